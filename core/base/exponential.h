// SPDX-License-Identifier: MIT
// What exp and tanh of base/math.h are made of, as templates on the number type: a double, or several side by side
// (base/lanes.h). This text is their only definition, so a lane's bits are those of the one number.
#pragma once

#include "base/vec2.h"

#include <bit>
#include <cmath>
#include <cstdint>

namespace planula::math {

/// ln 2 in two parts, of which a small integer times the first is exact.
inline constexpr double ln2_high = 0x1.62e42fefa0000p-1, ln2_low = 0x1.cf79abc9e3b39p-40;

/// 2^k for whole numbers k, -1022 <= k <= 1023.
PORTABLE inline double power_of_two(double k) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(static_cast<int>(k) + 1023) << 52);
}

/// The nearest integer, halves to even, by adding and taking away 1.5 * 2^52; |x| < 2^51.
template <class T> PORTABLE T nearest(T x) {
    const T shift(0x1.8p52);
    return (x + shift) - shift;
}

/// A polynomial by Horner's rule, coefficients from the highest power down.
template <class T, class... Coefficients> PORTABLE T horner(T x, double first, Coefficients... rest) {
    T sum(first);
    ((sum = sum * x + T(rest)), ...);
    return sum;
}

/// exp(r) - 1 for |r| <= 0.35: its Taylor series to r^14 (remainder below 2^-57 of the sum).
template <class T> PORTABLE T expm1_small(T r) {
    const T series =
        horner(r, 1.0 / 87178291200, 1.0 / 6227020800, 1.0 / 479001600, 1.0 / 39916800, 1.0 / 3628800,
               1.0 / 362880, 1.0 / 40320, 1.0 / 5040, 1.0 / 720, 1.0 / 120, 1.0 / 24, 1.0 / 6, 1.0 / 2);
    return r + r * r * series;
}

/// x = k ln 2 + r with |r| <= ln(2)/2.
template <class T> struct ExpReduced { T k, r; };
template <class T> PORTABLE ExpReduced<T> reduce_exp(T x) {
    const T k = nearest(x * T(1.44269504088896340736));
    return {k, (x - k * T(ln2_high)) - k * T(ln2_low)};
}

/// math::tanh: e / (e + 2) with e = exp(2|x|) - 1 and the sign of x; beyond 20 the result is 1 in double.
template <class T> PORTABLE T tanh_of(T x) {
    using std::abs, std::copysign;
    const T magnitude = abs(x), limit(20);
    const auto [k, r] = reduce_exp(T(2) * select(magnitude <= limit, magnitude, limit));
    const T scale = power_of_two(k);
    const T e = scale * expm1_small(r) + (scale - T(1));
    const T infinity(__builtin_inf());
    return select(magnitude <= infinity, copysign(e / (e + T(2)), x),
                  x); // NaN stays NaN
}

} // namespace planula::math
