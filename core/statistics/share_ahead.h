// SPDX-License-Identifier: MIT
// How far the mean curve of one sample of runs is ahead of that of another (Figs. 6 and 7, S6).
#pragma once

#include <span>

namespace planula {

/// Values of one run, place by place.
using Curve = std::span<const double>;

/// The share of places at which the mean of the curves of `a` is at least that of `b`. Throws
/// InputError unless there are curves on both sides, all with the same number of places, at least one. Values are
/// finite.
double share_ahead(std::span<const Curve> a, std::span<const Curve> b);

} // namespace planula
