// SPDX-License-Identifier: MIT
#include "statistics/rank_correlation.h"

#include "statistics/distributions.h"
#include "statistics/ranks.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <vector>

namespace planula {

namespace {

constexpr std::size_t most_counted = 9; // 9! orders

/// Twice the ranks' distances from their middle, which are whole numbers.
std::vector<int> centred(std::span<const double> sample) {
    std::vector<int> result;
    for (const double rank : ranks(sample).of)
        result.push_back(static_cast<int>(2 * rank) - static_cast<int>(sample.size() + 1));
    return result;
}

/// The share of all orders of b whose correlation with a is at least as far from 0.
double share_beyond(std::span<const double> a, std::span<const double> b) {
    const std::vector<int> x = centred(a), given = centred(b);
    const auto product = [&](const std::vector<int> &y, const std::vector<std::size_t> &order) {
        int sum = 0;
        for (std::size_t i = 0; i < x.size(); ++i) sum += x[i] * y[order[i]];
        return std::abs(sum);
    };
    std::vector<std::size_t> order(x.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const int distance = product(given, order);
    double beyond = 0, all = 0;
    do {
        beyond += product(given, order) >= distance;
        ++all;
    } while (std::next_permutation(order.begin(), order.end()));
    return beyond / all;
}

} // namespace

std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b) {
    check_pairs(a, b);
    const Ranks of_a = ranks(a), of_b = ranks(b);
    const double middle = static_cast<double>(a.size() + 1) / 2;
    double both = 0, alone_a = 0, alone_b = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const double x = of_a.of[i] - middle, y = of_b.of[i] - middle;
        both += x * y;
        alone_a += x * x;
        alone_b += y * y;
    }
    if (alone_a == 0 || alone_b == 0) return std::nullopt;
    return both / std::sqrt(alone_a * alone_b);
}

std::optional<RankCorrelation> rank_correlation_test(std::span<const double> a, std::span<const double> b) {
    const std::optional<double> rho = rank_correlation(a, b);
    if (!rho) return std::nullopt;
    if (a.size() <= most_counted) return RankCorrelation{*rho, share_beyond(a, b), true};
    const int freedom = static_cast<int>(a.size()) - 2;
    const double t = *rho * std::sqrt(freedom / (1 - *rho * *rho));
    return RankCorrelation{*rho, student_beyond(t, freedom), false};
}

} // namespace planula
