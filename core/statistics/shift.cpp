// SPDX-License-Identifier: MIT
#include "statistics/shift.h"

#include "statistics/demand.h"
#include "statistics/distributions.h"
#include "statistics/ranks.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace planula {

namespace {

std::vector<std::size_t> untied_ranks(std::size_t count) {
    std::vector<std::size_t> ranks(count);
    std::iota(ranks.begin(), ranks.end(), std::size_t{1});
    return ranks;
}

/// The smallest sum, from the first of these on, that is not below with a probability of `tail`.
double lower_quantile(std::span<const double> weights, double tail) {
    const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
    double below = 0;
    std::size_t sum = 0;
    while ((below += weights[sum]) < tail * all * (1 - 1e-12)) ++sum;
    return static_cast<double>(sum);
}

/// The same of a normal approximation, corrected for continuity.
double lower_quantile(double middle, double variance, double tail) {
    return std::max(0.0, std::ceil(middle + std::sqrt(variance) * normal_quantile(tail) - 0.5));
}

/// The differences' median, and the interval from the `from`-th smallest to the `from`-th largest of them.
Shift from_differences(std::vector<double> differences, double from) {
    Shift shift{median(differences), std::nullopt};
    if (from < 1) return shift;
    std::sort(differences.begin(), differences.end());
    const auto place = static_cast<std::size_t>(from);
    shift.interval = Interval{differences[place - 1], differences[differences.size() - place]};
    return shift;
}

double tail_of(double confidence) {
    demand(confidence > 0 && confidence < 1, "confidence is between 0 and 1", confidence);
    return (1 - confidence) / 2;
}

} // namespace

Shift shift(std::span<const double> a, std::span<const double> b, double confidence) {
    check_sample(a);
    check_sample(b);
    const double tail = tail_of(confidence);
    std::vector<double> differences;
    for (const double x : a)
        for (const double y : b) differences.push_back(x - y);

    const double m = static_cast<double>(a.size()), n = static_cast<double>(b.size());
    if (!is_exact(RankMethod::automatic, a.size(), b.size()))
        return from_differences(std::move(differences),
                                lower_quantile(m * n / 2, m * n * (m + n + 1) / 12, tail));
    const std::vector<double> ways = ways_to_sum(untied_ranks(a.size() + b.size()), a.size());
    const std::size_t smallest = a.size() * (a.size() + 1) / 2;
    return from_differences(std::move(differences), lower_quantile(std::span(ways).subspan(smallest), tail));
}

Shift paired_shift(std::span<const double> a, std::span<const double> b, double confidence) {
    check_pairs(a, b);
    const double tail = tail_of(confidence);
    std::vector<double> means;
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j <= i; ++j) means.push_back(((a[i] - b[i]) + (a[j] - b[j])) / 2);

    const double n = static_cast<double>(a.size());
    if (!is_exact(RankMethod::automatic, a.size(), b.size()))
        return from_differences(std::move(means),
                                lower_quantile(n * (n + 1) / 4, n * (n + 1) * (2 * n + 1) / 24, tail));
    return from_differences(std::move(means),
                            lower_quantile(chances_of_signed_sums(untied_ranks(a.size())), tail));
}

} // namespace planula
