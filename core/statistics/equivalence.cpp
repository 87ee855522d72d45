// SPDX-License-Identifier: MIT
#include "statistics/equivalence.h"

#include "base/check.h"
#include "base/math.h"
#include "statistics/effect_size.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// The variance, over the values of `a`, of the share of `b` that each exceeds, over their number; 0 for one value.
double placement_variance(std::span<const double> a, std::span<const double> b, double middle) {
    if (a.size() < 2) return 0;
    double squares = 0;
    for (const double &value : a) {
        const double distance = a12(std::span(&value, 1), b) - middle;
        squares += distance * distance;
    }
    const double m = static_cast<double>(a.size());
    return squares / (m - 1) / m;
}

double below_normal(double z) { return 0.5 * math::erfc(-z / std::sqrt(2.0)); }

} // namespace

Equivalence equivalence(std::span<const double> a, std::span<const double> b, double bound) {
    CHECK(bound > 0 && bound < 0.5, bound);
    const double effect = a12(a, b);
    const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
    const double even = std::sqrt((m + n + 1) / (12 * m * n));
    const double estimate =
        std::sqrt(placement_variance(a, b, effect) + placement_variance(b, a, 1 - effect));
    const double deviation = std::max(even, estimate);

    // The larger p of the two one-sided tests is that of the nearer end of the bound.
    const double room = bound - std::abs(effect - 0.5);
    return {effect, deviation, below_normal(-room / deviation), below_normal(-bound / even)};
}

} // namespace planula
