// SPDX-License-Identifier: MIT
// How large a difference is, beside how certain: the measure of stochastic superiority A12 of Vargha &
// Delaney (2000).
#pragma once

#include <span>

namespace planula {

/// The probability that a value of `a` exceeds one of `b`, ties counting half: 0.5 if neither tends to be
/// larger, 1 if every value of `a` is. Both are samples (statistics/summary.h).
double a12(std::span<const double> a, std::span<const double> b);

} // namespace planula
