// SPDX-License-Identifier: MIT
// Percentile bootstrap intervals (Efron & Tibshirani 1993, chapter 13; Figs. 6, 7 and 12): a statistic is
// computed for many samples drawn with replacement, and the interval is what lies between two quantiles of
// type 7 (statistics/summary.h), (1 − confidence)/2 from either end.
//
// All chance comes from the stream (seed; key, 0, bootstrap): intervals with different keys are drawn
// independently of each other, and each can be computed alone.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

namespace planula {

struct Resampling {
    double confidence; // coverage, in (0, 1)
    int resamples;     // at least 1
    std::uint64_t seed;
    std::uint32_t key; // which interval this is
};

struct Interval {
    double low, high;
};

/// Of the mean. A sample of one value, or of equal values, gives an interval of no width, up to rounding.
Interval bootstrap_mean(std::span<const double> sample, const Resampling &resampling);

using TwoSampleStatistic = std::function<double(std::span<const double> a, std::span<const double> b)>;

/// Of a statistic of two samples, each of which is resampled by itself. The statistic must be finite.
Interval bootstrap(std::span<const double> a, std::span<const double> b, const TwoSampleStatistic &statistic,
                   const Resampling &resampling);

} // namespace planula
