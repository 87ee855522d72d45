// SPDX-License-Identifier: MIT
#include "statistics/permutation.h"

#include "base/random.h"
#include "statistics/demand.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace planula {

namespace {

/// The number of ways to choose k of n, or `limit` if there are more.
double ways_to_choose(std::size_t n, std::size_t k, double limit) {
    double ways = 1;
    for (std::size_t i = 1; i <= k && ways < limit; ++i)
        ways *= static_cast<double>(n - k + i) / static_cast<double>(i);
    return std::min(std::round(ways), limit);
}

/// Sums of m of the values, for every way to choose them.
std::vector<double> every_sum(std::span<const double> values, std::size_t m) {
    std::vector<char> chosen(values.size());
    std::fill_n(chosen.begin(), m, 1);
    std::vector<double> sums;
    do {
        double sum = 0;
        for (std::size_t i = 0; i < values.size(); ++i) sum += chosen[i] ? values[i] : 0;
        sums.push_back(sum);
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
    return sums;
}

/// The sum of the first m, then sums of m values drawn without replacement.
std::vector<double> drawn_sums(std::vector<double> values, std::size_t m, const Shuffling &shuffling) {
    const auto first = [&] {
        return std::accumulate(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(m), 0.0);
    };
    Stream stream(shuffling.seed, shuffling.key, 0, Purpose::permutation);
    std::vector<double> sums{first()};
    for (int draw = 0; draw < shuffling.draws; ++draw) {
        for (std::size_t i = 0; i < m; ++i)
            std::swap(values[i], values[i + stream.below(static_cast<std::uint32_t>(values.size() - i))]);
        sums.push_back(first());
    }
    return sums;
}

/// The share of the sums at least so far from the middle, up to rounding.
double share_beyond(std::span<const double> sums, double middle, double distance, double rounding) {
    const auto beyond = std::count_if(
        sums.begin(), sums.end(), [&](double sum) { return std::abs(sum - middle) >= distance - rounding; });
    return static_cast<double>(beyond) / static_cast<double>(sums.size());
}

/// p and the least of the first of these sums, which is that at hand, by the distances from `middle`; sums of values
/// whose sizes add up to `size`.
Permutation judge(std::span<const double> sums, double middle, double size, double difference, bool exact) {
    double farthest = 0;
    for (const double sum : sums) farthest = std::max(farthest, std::abs(sum - middle));
    const double rounding = 1e-12 * size;
    const double p = share_beyond(sums, middle, std::abs(sums.front() - middle), rounding);
    const double least =
        exact ? share_beyond(sums, middle, farthest, rounding) : 1 / static_cast<double>(sums.size());
    return {difference, p, least, exact};
}

double sum_of_sizes(std::span<const double> values) {
    double size = 0;
    for (const double value : values) size += std::abs(value);
    return size;
}

/// Sums of the differences, for every way to choose their signs; the first as they are.
std::vector<double> every_signed_sum(std::span<const double> differences) {
    std::vector<double> sums;
    for (std::uint64_t flips = 0; flips < std::uint64_t{1} << differences.size(); ++flips) {
        double sum = 0;
        for (std::size_t i = 0; i < differences.size(); ++i)
            sum += flips >> i & 1 ? -differences[i] : differences[i];
        sums.push_back(sum);
    }
    return sums;
}

/// The sum of the differences, then sums with drawn signs.
std::vector<double> drawn_signed_sums(std::span<const double> differences, const Shuffling &shuffling) {
    Stream stream(shuffling.seed, shuffling.key, 0, Purpose::permutation);
    std::vector<double> sums{std::accumulate(differences.begin(), differences.end(), 0.0)};
    for (int draw = 0; draw < shuffling.draws; ++draw) {
        double sum = 0;
        for (const double difference : differences) sum += stream.below(2) == 0 ? difference : -difference;
        sums.push_back(sum);
    }
    return sums;
}

void check_shuffling(const Shuffling &shuffling) {
    demand(shuffling.draws >= 1, "a permutation test has at least 1 draw", shuffling.draws);
}

} // namespace

Permutation permutation_test(std::span<const double> a, std::span<const double> b,
                             const Shuffling &shuffling) {
    check_sample(a);
    check_sample(b);
    check_shuffling(shuffling);
    std::vector<double> values(a.begin(), a.end());
    values.insert(values.end(), b.begin(), b.end());
    const double most = shuffling.draws + 1.0;
    const bool exact = ways_to_choose(values.size(), a.size(), most) < most;
    const std::vector<double> sums =
        exact ? every_sum(values, a.size()) : drawn_sums(values, a.size(), shuffling);

    // The first sum is that of a.
    const double middle = mean(values) * static_cast<double>(a.size());
    return judge(sums, middle, sum_of_sizes(values), mean(a) - mean(b), exact);
}

Permutation paired_permutation_test(std::span<const double> a, std::span<const double> b,
                                    const Shuffling &shuffling) {
    check_pairs(a, b);
    check_shuffling(shuffling);
    std::vector<double> differences;
    for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(a[i] - b[i]);
    constexpr std::size_t most_bits = 30; // draws is an int
    const bool exact = differences.size() <= most_bits &&
                       (std::uint64_t{1} << differences.size()) <= std::uint64_t(shuffling.draws);
    const std::vector<double> sums =
        exact ? every_signed_sum(differences) : drawn_signed_sums(differences, shuffling);
    return judge(sums, 0, sum_of_sizes(differences), mean(differences), exact);
}

} // namespace planula
