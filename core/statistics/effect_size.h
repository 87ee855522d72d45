// SPDX-License-Identifier: MIT
// How large a difference is, beside how certain: the measure of stochastic superiority A12 of Vargha & Delaney (2000),
// and Cliff's delta (1993), which says the same on another scale.
#pragma once

#include <span>

namespace planula {

/// The probability that a value of `a` exceeds one of `b`, ties counting half: 0.5 if neither tends to be
/// larger, 1 if every value of `a` is. Both are samples (statistics/summary.h).
double a12(std::span<const double> a, std::span<const double> b);

/// The probability that a value of `a` exceeds one of `b`, less that of the reverse: 2 A12 - 1, from -1 to 1.
double cliff_delta(std::span<const double> a, std::span<const double> b);

} // namespace planula
