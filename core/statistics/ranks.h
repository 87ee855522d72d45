// SPDX-License-Identifier: MIT
// Ranks of a sample, for the statistics that look at nothing else (decision 0015).
#pragma once

#include <span>
#include <vector>

namespace planula {

struct Ranks {
    std::vector<double> of; // the rank of each value, from 1, as given; equal values share their mean rank
    double tie_cubes = 0;   // Σ t³ − t over groups of t equal values
};

/// Ranks a sample (statistics/summary.h), the smallest value first.
Ranks ranks(std::span<const double> sample);

} // namespace planula
