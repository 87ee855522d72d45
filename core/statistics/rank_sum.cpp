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

/// P(U = u) for u = 0 … m·n without ties. The largest value of all belongs to the first sample with
/// probability m/(m + n), and then exceeds all n of the second: no term is ever subtracted.
std::vector<double> exact_distribution(std::size_t m, std::size_t n) {
    std::vector<std::vector<double>> row(m + 1, std::vector<double>(m * n + 1));
    for (auto &of_i : row) of_i[0] = 1;
    for (std::size_t j = 1; j <= n; ++j)
        for (std::size_t i = 1; i <= m; ++i) {
            const double first_wins = static_cast<double>(i) / static_cast<double>(i + j);
            for (std::size_t u = 0; u <= i * j; ++u)
                row[i][u] = (1 - first_wins) * row[i][u] + (u >= j ? first_wins * row[i - 1][u - j] : 0);
        }
    return row[m];
}

/// Twice the smaller tail of the exact distribution, at most 1; U is symmetric about m·n/2.
double exact_p(double statistic, std::size_t m, std::size_t n) {
    const std::vector<double> probability = exact_distribution(m, n);
    const double lower = std::min(statistic, static_cast<double>(m * n) - statistic);
    double tail = 0;
    for (std::size_t u = 0; u <= static_cast<std::size_t>(lower); ++u) tail += probability[u];
    return std::min(1.0, 2 * tail);
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

    constexpr std::size_t exact_below = 50; // as R's wilcox.test
    const bool small = a.size() < exact_below && b.size() < exact_below;
    const bool wanted = method == RankSumMethod::exact || (method == RankSumMethod::automatic && small);
    const bool exact = wanted && pooled_ranks.tie_cubes == 0;
    const double p =
        exact ? exact_p(statistic, a.size(), b.size()) : normal_p(statistic, m, n, pooled_ranks.tie_cubes);
    return {statistic, p, exact};
}

} // namespace planula
