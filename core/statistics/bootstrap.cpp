// SPDX-License-Identifier: MIT
#include "statistics/bootstrap.h"

#include "base/check.h"
#include "base/random.h"
#include "statistics/summary.h"

#include <vector>

namespace planula {

namespace {

void check_resampling(const Resampling &resampling) {
    CHECK(resampling.confidence > 0 && resampling.confidence < 1, resampling.confidence);
    CHECK(resampling.resamples >= 1, resampling.resamples);
}

/// As many values as the sample has, drawn from it with replacement.
void draw(std::span<const double> sample, Stream &stream, std::vector<double> &resample) {
    resample.clear();
    for (std::size_t i = 0; i < sample.size(); ++i)
        resample.push_back(sample[stream.below(static_cast<std::uint32_t>(sample.size()))]);
}

Interval percentile_interval(std::span<const double> statistics, double confidence) {
    const double tail = (1 - confidence) / 2;
    return {quantile(statistics, tail), quantile(statistics, 1 - tail)};
}

} // namespace

Interval bootstrap_mean(std::span<const double> sample, const Resampling &resampling) {
    check_sample(sample);
    check_resampling(resampling);
    Stream stream(resampling.seed, resampling.key, 0, Purpose::bootstrap);
    std::vector<double> means, resample;
    for (int i = 0; i < resampling.resamples; ++i) {
        draw(sample, stream, resample);
        means.push_back(mean(resample));
    }
    return percentile_interval(means, resampling.confidence);
}

Interval bootstrap(std::span<const double> a, std::span<const double> b, const TwoSampleStatistic &statistic,
                   const Resampling &resampling) {
    check_sample(a);
    check_sample(b);
    check_resampling(resampling);
    Stream stream(resampling.seed, resampling.key, 0, Purpose::bootstrap);
    std::vector<double> values, resample_a, resample_b;
    for (int i = 0; i < resampling.resamples; ++i) {
        draw(a, stream, resample_a);
        draw(b, stream, resample_b);
        values.push_back(statistic(resample_a, resample_b));
    }
    return percentile_interval(values, resampling.confidence);
}

} // namespace planula
