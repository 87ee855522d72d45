// SPDX-License-Identifier: MIT
#include "statistics/equivalence.h"

#include "statistics/demand.h"
#include "statistics/distributions.h"
#include "statistics/effect_size.h"
#include "statistics/signed_rank.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <vector>

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

} // namespace

Equivalence equivalence(std::span<const double> a, std::span<const double> b, double bound) {
    demand(bound > 0 && bound < 0.5, "the bound of an equivalence of A12 is between 0 and 0.5", bound);
    const double effect = a12(a, b);
    const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
    const double even = std::sqrt((m + n + 1) / (12 * m * n));
    const double estimate =
        std::sqrt(placement_variance(a, b, effect) + placement_variance(b, a, 1 - effect));
    const double deviation = std::max(even, estimate);

    // The larger p of the two one-sided tests is that of the nearer end of the bound.
    const double room = bound - std::abs(effect - 0.5);
    return {effect, deviation, normal_below(-room / deviation), normal_below(-bound / even)};
}

double paired_equivalence(std::span<const double> a, std::span<const double> b, double bound) {
    demand(bound > 0 && std::isfinite(bound), "the bound of an equivalence of pairs is a number above 0",
           bound);
    check_pairs(a, b);
    std::vector<double> from_low, from_high;
    for (std::size_t i = 0; i < a.size(); ++i) {
        from_low.push_back(a[i] - b[i] + bound);
        from_high.push_back(a[i] - b[i] - bound);
    }
    const std::vector<double> zeros(a.size());
    return std::max(signed_rank(from_low, zeros).greater, signed_rank(from_high, zeros).less);
}

} // namespace planula
