// SPDX-License-Identifier: MIT
#include "statistics/signed_rank.h"

#include "statistics/distributions.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace planula {

namespace {

double two_sided(double greater, double less) { return std::min(1.0, 2 * std::min(greater, less)); }

void test_exactly(const Ranks &ranks, SignedRank &test) {
    const std::vector<double> chances = chances_of_signed_sums(doubled(ranks));
    const auto sum = static_cast<std::ptrdiff_t>(2 * test.statistic);
    // Tails from their thin end on, so that small ones are exact.
    test.less = std::accumulate(chances.begin(), chances.begin() + sum + 1, 0.0);
    test.greater = std::accumulate(chances.rbegin(), chances.rend() - sum, 0.0);
    test.least = two_sided(chances.front(), chances.front());
}

void test_normally(const Ranks &ranks, double correction, SignedRank &test) {
    const double n = static_cast<double>(ranks.of.size()), middle = n * (n + 1) / 4;
    const double deviation = std::sqrt(n * (n + 1) * (2 * n + 1) / 24 - ranks.tie_cubes / 48);
    const auto below = [&](double distance) { return normal_below((distance + correction) / deviation); };
    test.less = below(test.statistic - middle);
    test.greater = below(middle - test.statistic);
    test.least = two_sided(below(-middle), below(-middle));
    test.exact = false;
}

} // namespace

SignedRank signed_rank(std::span<const double> a, std::span<const double> b, RankMethod method) {
    check_pairs(a, b);
    std::vector<double> sizes;
    std::vector<char> is_positive;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double difference = a[i] - b[i];
        if (difference == 0) continue;
        sizes.push_back(std::abs(difference));
        is_positive.push_back(difference > 0);
    }
    SignedRank test;
    test.differences = sizes.size();
    if (sizes.empty()) return test;

    const Ranks of_sizes = ranks(sizes);
    for (std::size_t i = 0; i < sizes.size(); ++i) test.statistic += is_positive[i] ? of_sizes.of[i] : 0;
    if (is_exact(method, sizes.size(), sizes.size()))
        test_exactly(of_sizes, test);
    else
        test_normally(of_sizes, method == RankMethod::normal_without_continuity ? 0 : 0.5, test);
    test.p = two_sided(test.greater, test.less);
    return test;
}

} // namespace planula
