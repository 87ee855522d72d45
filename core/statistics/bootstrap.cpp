// SPDX-License-Identifier: MIT
#include "statistics/bootstrap.h"

#include "base/random.h"
#include "statistics/demand.h"
#include "statistics/distributions.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace planula {

namespace {

void check_resampling(const Resampling &resampling, std::size_t values) {
    demand(resampling.confidence > 0 && resampling.confidence < 1, "confidence is between 0 and 1",
           resampling.confidence);
    demand(resampling.resamples >= 1, "a bootstrap has at least 1 resample", resampling.resamples);
    if (resampling.kind == IntervalKind::bca)
        demand(values >= 2, "a BCa interval needs at least 2 values of each sample",
               static_cast<double>(values));
}

/// Places of a sample, drawn with replacement.
std::size_t draw_place(std::size_t size, Stream &stream) {
    return stream.below(static_cast<std::uint32_t>(size));
}

/// As many values as the sample has, drawn from it with replacement.
void draw(std::span<const double> sample, Stream &stream, std::vector<double> &resample) {
    resample.clear();
    for (std::size_t i = 0; i < sample.size(); ++i)
        resample.push_back(sample[draw_place(sample.size(), stream)]);
}

void draw_pairs(std::span<const double> a, std::span<const double> b, Stream &stream,
                std::vector<double> &resample_a, std::vector<double> &resample_b) {
    resample_a.clear(), resample_b.clear();
    for (std::size_t i = 0; i < a.size(); ++i) {
        const std::size_t place = draw_place(a.size(), stream);
        resample_a.push_back(a[place]);
        resample_b.push_back(b[place]);
    }
}

std::vector<double> without(std::span<const double> sample, std::size_t place) {
    std::vector<double> rest(sample.begin(), sample.end());
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
    return rest;
}

/// Appends the influence of each value of a sample on a statistic: how far leaving it out moves the statistic from the
/// mean of all that leave one out (Efron & Tibshirani 1993, Eq. 14.15), times (n − 1)/n, by which those of samples of
/// different sizes can be added (Davison & Hinkley 1997, §5.3.1).
template <class LeaveOut>
void add_influence(std::size_t n, LeaveOut &&statistic_without, std::vector<double> &all) {
    std::vector<double> values;
    for (std::size_t i = 0; i < n; ++i) values.push_back(statistic_without(i));
    const double middle = mean(values), size = static_cast<double>(n);
    for (const double value : values) all.push_back((middle - value) * (size - 1) / size);
}

Interval percentile_interval(std::span<const double> replicates, double confidence) {
    const double tail = (1 - confidence) / 2;
    return {quantile(replicates, tail), quantile(replicates, 1 - tail)};
}

/// Quantile of ascending replicates, linear in the quantiles of the normal distribution (Davison & Hinkley 1997, Eq.
/// 5.8).
double normal_interpolated(const std::vector<double> &sorted, double probability) {
    const double count = static_cast<double>(sorted.size()), rank = (count + 1) * probability;
    const double whole = std::floor(rank);
    if (whole < 1) return sorted.front();
    if (whole >= count) return sorted.back();
    const double low = sorted[static_cast<std::size_t>(whole) - 1],
                 high = sorted[static_cast<std::size_t>(whole)];
    const double from = normal_quantile(whole / (count + 1)), to = normal_quantile((whole + 1) / (count + 1));
    return whole == rank ? low : low + (normal_quantile(probability) - from) / (to - from) * (high - low);
}

double acceleration(std::span<const double> influence) {
    double squares = 0, cubes = 0;
    for (const double value : influence) squares += value * value, cubes += value * value * value;
    return squares > 0 ? cubes / (6 * squares * std::sqrt(squares)) : 0;
}

} // namespace

Interval bca_interval(double estimate, std::span<const double> replicates, std::span<const double> influence,
                      double confidence) {
    check_sample(replicates);
    check_sample(influence);
    demand(confidence > 0 && confidence < 1, "confidence is between 0 and 1", confidence);
    std::vector<double> sorted(replicates.begin(), replicates.end());
    std::sort(sorted.begin(), sorted.end());
    if (sorted.front() == estimate && sorted.back() == estimate) return {estimate, estimate};
    const double below =
        static_cast<double>(std::lower_bound(sorted.begin(), sorted.end(), estimate) - sorted.begin()) /
        static_cast<double>(sorted.size());
    demand(below > 0 && below < 1,
           "a BCa interval needs replicates on both sides of the estimate; the share below it is between 0 "
           "and 1",
           below);

    const double bias = normal_quantile(below), a = acceleration(influence);
    const auto end = [&](double tail) {
        const double shifted = bias + normal_quantile(tail);
        return normal_interpolated(sorted, normal_below(bias + shifted / (1 - a * shifted)));
    };
    return {end((1 - confidence) / 2), end((1 + confidence) / 2)};
}

Interval bootstrap(std::span<const double> sample, const OneSampleStatistic &statistic,
                   const Resampling &resampling) {
    check_sample(sample);
    check_resampling(resampling, sample.size());
    Stream stream(resampling.seed, resampling.key, 0, Purpose::bootstrap);
    std::vector<double> values, resample;
    for (int i = 0; i < resampling.resamples; ++i) {
        draw(sample, stream, resample);
        values.push_back(statistic(resample));
    }
    if (resampling.kind == IntervalKind::percentile)
        return percentile_interval(values, resampling.confidence);
    std::vector<double> influence;
    add_influence(
        sample.size(), [&](std::size_t i) { return statistic(without(sample, i)); }, influence);
    return bca_interval(statistic(sample), values, influence, resampling.confidence);
}

Interval bootstrap_mean(std::span<const double> sample, const Resampling &resampling) {
    return bootstrap(sample, mean, resampling);
}

Interval bootstrap(std::span<const double> a, std::span<const double> b, const TwoSampleStatistic &statistic,
                   const Resampling &resampling) {
    check_sample(a);
    check_sample(b);
    check_resampling(resampling, std::min(a.size(), b.size()));
    Stream stream(resampling.seed, resampling.key, 0, Purpose::bootstrap);
    std::vector<double> values, resample_a, resample_b;
    for (int i = 0; i < resampling.resamples; ++i) {
        draw(a, stream, resample_a);
        draw(b, stream, resample_b);
        values.push_back(statistic(resample_a, resample_b));
    }
    if (resampling.kind == IntervalKind::percentile)
        return percentile_interval(values, resampling.confidence);
    std::vector<double> influence;
    add_influence(
        a.size(), [&](std::size_t i) { return statistic(without(a, i), b); }, influence);
    add_influence(
        b.size(), [&](std::size_t i) { return statistic(a, without(b, i)); }, influence);
    return bca_interval(statistic(a, b), values, influence, resampling.confidence);
}

Interval bootstrap_pairs(std::span<const double> a, std::span<const double> b,
                         const TwoSampleStatistic &statistic, const Resampling &resampling) {
    check_pairs(a, b);
    check_resampling(resampling, a.size());
    Stream stream(resampling.seed, resampling.key, 0, Purpose::bootstrap);
    std::vector<double> values, resample_a, resample_b;
    for (int i = 0; i < resampling.resamples; ++i) {
        draw_pairs(a, b, stream, resample_a, resample_b);
        values.push_back(statistic(resample_a, resample_b));
    }
    if (resampling.kind == IntervalKind::percentile)
        return percentile_interval(values, resampling.confidence);
    std::vector<double> influence;
    add_influence(
        a.size(), [&](std::size_t i) { return statistic(without(a, i), without(b, i)); }, influence);
    return bca_interval(statistic(a, b), values, influence, resampling.confidence);
}

} // namespace planula
