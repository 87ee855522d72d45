// SPDX-License-Identifier: MIT
// Summaries of many values by one, and what this room calls a sample: at least one value, all of them finite. Every
// function of the room throws InputError, with the rule and the value, for samples or settings that break its rules;
// only entropy is defined without a value. A sample of one value, or of equal values, is valid: its mean, its median
// and all its quantiles are that value.
#pragma once

#include <span>

namespace planula {

struct Interval {
    double low, high;
};

/// Throws InputError if there is no value, or one that is not finite.
void check_sample(std::span<const double> sample);

/// Throws InputError unless both are samples of the same size: (a[i], b[i]) is a pair.
void check_pairs(std::span<const double> a, std::span<const double> b);

/// The sum, in the order given, divided by the count.
double mean(std::span<const double> sample);

/// Quantile at `probability` in [0, 1], linear between order statistics: type 7 of Hyndman & Fan (1996), R's
/// default.
double quantile(std::span<const double> sample, double probability);

/// The quantile at 1/2: the middle value, or the mean of the two in the middle.
double median(std::span<const double> sample);

} // namespace planula
