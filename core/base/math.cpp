// SPDX-License-Identifier: MIT
#include "base/math.h"

#include "base/exponential.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace planula::math {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

// π/2 split so that a small integer times every part but the last is exact.
constexpr double half_pi_1 = 0x1.921fb54400000p0, half_pi_2 = 0x1.0b4611a600000p-34,
                 half_pi_3 = 0x1.3198a2e037073p-69;

/// sin and cos for |r| <= π/4 + a little: Taylor series to r^17 and r^18.
double sin_small(double r) {
    const double s = r * r;
    return r + r * s *
                   horner(s, 1.0 / 355687428096000, -1.0 / 1307674368000, 1.0 / 6227020800, -1.0 / 39916800,
                          1.0 / 362880, -1.0 / 5040, 1.0 / 120, -1.0 / 6);
}
double cos_small(double r) {
    const double s = r * r;
    return 1 - s * (0.5 - s * horner(s, -1.0 / 6402373705728000, 1.0 / 20922789888000, -1.0 / 87178291200,
                                     1.0 / 479001600, -1.0 / 3628800, 1.0 / 40320, -1.0 / 720, 1.0 / 24));
}

/// sin(x + quarters * π/2).
double sin_shifted(double x, int quarters) {
    if (!std::isfinite(x)) return not_a_number;
    if (std::abs(x) > 0x1p20) x = std::fmod(x, 2 * pi); // fmod is exact, so the same everywhere
    const double k = nearest(x * (2 / pi));
    const double r = ((x - k * half_pi_1) - k * half_pi_2) - k * half_pi_3;
    switch ((static_cast<std::int64_t>(k) + quarters) & 3) {
    case 0:
        return sin_small(r);
    case 1:
        return cos_small(r);
    case 2:
        return -sin_small(r);
    default:
        return -cos_small(r);
    }
}

/// atan for |x| <= tan(π/16): its alternating series to x^23.
double atan_small(double x) {
    const double s = x * x;
    return x - x * s *
                   horner(s, 1.0 / 23, -1.0 / 21, 1.0 / 19, -1.0 / 17, 1.0 / 15, -1.0 / 13, 1.0 / 11,
                          -1.0 / 9, 1.0 / 7, -1.0 / 5, 1.0 / 3);
}

} // namespace

double sin(double x) { return sin_shifted(x, 0); }
double cos(double x) { return sin_shifted(x, 1); }

double exp(double x) {
    if (x > 709.782712893384) return infinity;
    if (x < -745.2) return 0;
    if (std::isnan(x)) return x;
    const auto [k, r] = reduce_exp(x);
    // The scale is applied in two steps so that neither leaves the range of normal numbers.
    const double half = std::trunc(k / 2);
    return (1 + expm1_small(r)) * power_of_two(half) * power_of_two(k - half);
}

double log(double x) {
    if (std::isnan(x) || x < 0) return not_a_number;
    if (x == 0) return -infinity;
    if (x == infinity) return x;

    // x = 2^k m with sqrt(1/2) <= m < sqrt(2).
    int k = 0;
    if (x < 0x1p-1022) x *= 0x1p54, k = -54;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    k += static_cast<int>(bits >> 52) - 1023;
    double m = std::bit_cast<double>((bits & 0x000fffffffffffff) | 0x3ff0000000000000);
    if (m > 1.41421356237309504880) m /= 2, ++k;

    // log m = 2 artanh(s) with f = m - 1 (exact) and s = f / (2 + f), written as f - f²/2 + s (f²/2 + series).
    const double f = m - 1, s = f / (2 + f), z = s * s, half_square = 0.5 * f * f;
    const double series = z * horner(z, 2.0 / 23, 2.0 / 21, 2.0 / 19, 2.0 / 17, 2.0 / 15, 2.0 / 13, 2.0 / 11,
                                     2.0 / 9, 2.0 / 7, 2.0 / 5, 2.0 / 3);
    return k * ln2_high + (f - (half_square - (s * (half_square + series) + k * ln2_low)));
}

double tanh(double x) { return tanh_of(x); }

double atan(double x) {
    if (std::isnan(x)) return x;
    // Three exact-enough steps towards 0: reciprocal, then twice the half angle.
    const double a = std::abs(x);
    double t = a > 1 ? 1 / a : a;
    t = t / (1 + std::sqrt(1 + t * t));
    t = t / (1 + std::sqrt(1 + t * t));
    const double angle = 4 * atan_small(t);
    return std::copysign(a > 1 ? pi / 2 - angle : angle, x);
}

double atan2(double y, double x) {
    if (std::isnan(x) || std::isnan(y)) return not_a_number;
    if (y == 0) return std::signbit(x) ? std::copysign(pi, y) : y;
    if (x == 0) return std::copysign(pi / 2, y);
    if (std::isinf(x) && std::isinf(y)) return std::copysign(x > 0 ? pi / 4 : 3 * pi / 4, y);
    const double angle = atan(std::abs(y / x));
    return std::copysign(x > 0 ? angle : pi - angle, y);
}

double erfc(double x) {
    constexpr double inverse_sqrt_pi = 0.564189583547756286948;
    if (std::isnan(x)) return x;
    if (x < 0) return 2 - erfc(-x);
    if (x > 27.3) return 0;
    if (x < 1.5) {
        // erf x = 2/sqrt(π) exp(-x²) Σ 2^n x^(2n+1) / (2n+1)!!: positive terms, no cancellation.
        double term = x, sum = x;
        for (int n = 1; term > 1e-18 * sum; ++n) sum += term *= 2 * x * x / (2 * n + 1);
        return 1 - 2 * inverse_sqrt_pi * exp(-x * x) * sum;
    }
    // The continued fraction x + (1/2)/(x + 1/(x + (3/2)/(x + …))), from the far end.
    double fraction = x;
    for (int n = 160; n >= 1; --n) fraction = x + 0.5 * n / fraction;
    return inverse_sqrt_pi * exp(-x * x) / fraction;
}

double pow(double x, double y) {
    if (y == 0 || x == 1) return 1;
    if (y == std::trunc(y) && std::abs(y) <= 1024) {
        double result = 1, square = x;
        for (int n = static_cast<int>(std::abs(y)); n > 0; n >>= 1) {
            if (n & 1) result *= square;
            square *= square;
        }
        return y < 0 ? 1 / result : result;
    }
    if (x == 0) return y < 0 ? infinity : 0;
    return exp(y * log(x));
}

} // namespace planula::math
