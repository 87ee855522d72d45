// SPDX-License-Identifier: MIT
#include "statistics/rank_sum.h"

#include "base/math.h"
#include "statistics/distributions.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

namespace planula {

namespace {

/// The probability of a sum at least as far from the middle as this one.
double tail(const std::vector<double> &ways, double middle, double sum) {
    double beyond = 0, all = 0;
    for (std::size_t s = 0; s < ways.size(); ++s) {
        all += ways[s];
        if (std::abs(static_cast<double>(s) - middle) >= std::abs(sum - middle)) beyond += ways[s];
    }
    return std::min(1.0, beyond / all);
}

RankSum exact_test(const Ranks &pooled, std::size_t m, double sum_of_a, double statistic) {
    const std::vector<std::size_t> whole = doubled(pooled);
    const std::vector<double> ways = ways_to_sum(whole, m);
    const double middle = static_cast<double>(m * (whole.size() + 1)); // twice the mean rank, m times
    const auto smallest = static_cast<double>(
        std::accumulate(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(m), std::size_t{0}));
    const auto largest = static_cast<double>(ways.size() - 1);
    const double farthest = middle - smallest > largest - middle ? smallest : largest;
    return {statistic, tail(ways, middle, 2 * sum_of_a), tail(ways, middle, farthest), true};
}

double normal_p(double statistic, double m, double n, double tie_cubes, double correction) {
    const double total = m + n;
    const double variance = m * n / 12 * (total + 1 - tie_cubes / (total * (total - 1)));
    const double distance = std::abs(statistic - m * n / 2) - correction;
    if (!(variance > 0) || distance <= 0) return 1;
    return math::erfc(distance / std::sqrt(2 * variance));
}

} // namespace

RankSum rank_sum(std::span<const double> a, std::span<const double> b, RankMethod method) {
    check_sample(a);
    check_sample(b);
    std::vector<double> pooled(a.begin(), a.end());
    pooled.insert(pooled.end(), b.begin(), b.end());
    const Ranks pooled_ranks = ranks(pooled);
    const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
    const double sum_of_a =
        std::accumulate(pooled_ranks.of.begin(), pooled_ranks.of.begin() + std::ssize(a), 0.0);
    const double statistic = sum_of_a - m * (m + 1) / 2;

    if (is_exact(method, a.size(), b.size())) return exact_test(pooled_ranks, a.size(), sum_of_a, statistic);
    const double correction = method == RankMethod::normal_without_continuity ? 0 : 0.5;
    return {statistic, normal_p(statistic, m, n, pooled_ranks.tie_cubes, correction),
            normal_p(0, m, n, pooled_ranks.tie_cubes, correction), false};
}

} // namespace planula
