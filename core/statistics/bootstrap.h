// SPDX-License-Identifier: MIT
// Bootstrap intervals: a statistic is computed for many samples drawn with replacement. Two kinds:
//
//   percentile  what lies between two quantiles of type 7 (statistics/summary.h), (1 − confidence)/2 from either end
//               (Efron & Tibshirani 1993, chapter 13; Figs. 6, 7 and 12)
//   BCa         bias-corrected and accelerated (Efron 1987): the quantiles move with the bias of the replicates and
//               with how the spread changes with the value, estimated by leaving out one value after the other; more
//               exact for skewed statistics, from two values of each sample on
//
// All chance comes from the stream (seed; key, 0, bootstrap): intervals with different keys are drawn independently of
// each other, and each can be computed alone.
#pragma once

#include "statistics/summary.h"

#include <cstdint>
#include <functional>
#include <span>

namespace planula {

enum class IntervalKind { percentile, bca };

struct Resampling {
    double confidence; // coverage, in (0, 1)
    int resamples;     // at least 1
    std::uint64_t seed;
    std::uint32_t key; // which interval this is
    IntervalKind kind = IntervalKind::percentile;
};

using OneSampleStatistic = std::function<double(std::span<const double> sample)>;
using TwoSampleStatistic = std::function<double(std::span<const double> a, std::span<const double> b)>;

/// Of a statistic of a sample. Statistics must be finite.
Interval bootstrap(std::span<const double> sample, const OneSampleStatistic &statistic,
                   const Resampling &resampling);

/// Of the mean. A sample of one value, or of equal values, gives an interval of no width, up to rounding.
Interval bootstrap_mean(std::span<const double> sample, const Resampling &resampling);

/// Of a statistic of two samples, each of which is resampled by itself.
Interval bootstrap(std::span<const double> a, std::span<const double> b, const TwoSampleStatistic &statistic,
                   const Resampling &resampling);

/// Of a statistic of two samples whose values are pairs, which are resampled together.
Interval bootstrap_pairs(std::span<const double> a, std::span<const double> b,
                         const TwoSampleStatistic &statistic, const Resampling &resampling);

/// The BCa interval of given replicates: what R's boot::boot.ci(type = "bca") computes. `estimate` is the statistic of
/// the sample, and `influence` that of each of its values, up to a common factor. Equal influences count as none.
/// Replicates that all equal the estimate give that. Throws InputError if all of them lie on one side of the estimate:
/// such a statistic has no BCa interval.
Interval bca_interval(double estimate, std::span<const double> replicates, std::span<const double> influence,
                      double confidence);

} // namespace planula
