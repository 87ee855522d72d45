// SPDX-License-Identifier: MIT
#include "statistics/rank_sum.h"

#include "base/math.h"
#include "statistics/ranks.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <vector>

namespace planula {

namespace {

/// Ranks as whole numbers, ascending: doubled, since the mean rank of an even number of equal values ends in a half.
std::vector<std::size_t> doubled_ranks(const Ranks &pooled) {
    std::vector<std::size_t> doubled;
    for (const double rank : pooled.of) doubled.push_back(static_cast<std::size_t>(2 * rank));
    std::sort(doubled.begin(), doubled.end());
    return doubled;
}

/// The number of ways to choose m of the ranks, by their sum: count[s] have sum s. All ways are equally likely if the
/// two samples do not differ, whatever ties there are.
std::vector<double> count_sums(const std::vector<std::size_t> &ranks, std::size_t m) {
    const std::size_t largest =
        std::accumulate(ranks.end() - static_cast<std::ptrdiff_t>(m), ranks.end(), std::size_t{0});
    std::vector<std::vector<double>> ways(m + 1, std::vector<double>(largest + 1));
    ways[0][0] = 1;
    // One rank after the other is chosen or not; the i chosen are at most this one.
    for (const std::size_t rank : ranks)
        for (std::size_t i = m; i >= 1; --i)
            for (std::size_t sum = std::min(i * rank, largest); sum >= rank; --sum)
                ways[i][sum] += ways[i - 1][sum - rank];
    return ways[m];
}

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
    const std::vector<std::size_t> doubled = doubled_ranks(pooled);
    const std::vector<double> ways = count_sums(doubled, m);
    const double middle = static_cast<double>(m * (doubled.size() + 1)); // twice the mean rank, m times
    const auto smallest = static_cast<double>(
        std::accumulate(doubled.begin(), doubled.begin() + static_cast<std::ptrdiff_t>(m), std::size_t{0}));
    const auto largest = static_cast<double>(ways.size() - 1);
    const double farthest = middle - smallest > largest - middle ? smallest : largest;
    return {statistic, tail(ways, middle, 2 * sum_of_a), tail(ways, middle, farthest), true};
}

double normal_p(double statistic, double m, double n, double tie_cubes) {
    const double total = m + n;
    const double variance = m * n / 12 * (total + 1 - tie_cubes / (total * (total - 1)));
    const double distance = std::abs(statistic - m * n / 2) - 0.5;
    if (!(variance > 0) || distance <= 0) return 1;
    return math::erfc(distance / std::sqrt(2 * variance));
}

} // namespace

RankSum rank_sum(std::span<const double> a, std::span<const double> b, RankSumMethod method) {
    check_sample(a);
    check_sample(b);
    std::vector<double> pooled(a.begin(), a.end());
    pooled.insert(pooled.end(), b.begin(), b.end());
    const Ranks pooled_ranks = ranks(pooled);
    const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
    const double sum_of_a =
        std::accumulate(pooled_ranks.of.begin(), pooled_ranks.of.begin() + std::ssize(a), 0.0);
    const double statistic = sum_of_a - m * (m + 1) / 2;

    const bool small = a.size() < exact_below && b.size() < exact_below;
    if (method == RankSumMethod::exact || (method == RankSumMethod::automatic && small))
        return exact_test(pooled_ranks, a.size(), sum_of_a, statistic);
    return {statistic, normal_p(statistic, m, n, pooled_ranks.tie_cubes),
            normal_p(0, m, n, pooled_ranks.tie_cubes), false};
}

} // namespace planula
