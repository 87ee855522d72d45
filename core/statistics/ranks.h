// SPDX-License-Identifier: MIT
// Ranks of a sample, for the statistics that look at nothing else (decision 0015).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace planula {

struct Ranks {
    std::vector<double> of; // the rank of each value, from 1, as given; equal values share their mean rank
    double tie_cubes = 0;   // Σ t³ − t over groups of t equal values
};

/// How the p of a rank test is computed.
enum class RankMethod {
    automatic, // exact if each sample is smaller than `exact_below`, else normal
    exact,     // of at most `exact_most` values in a sample
    normal,    // normal approximation, corrected for ties and for continuity
    normal_without_continuity
};
inline constexpr std::size_t exact_below = 50; // as R's wilcox.test
inline constexpr std::size_t exact_most = 100; // more take too long

/// Whether p of two samples is to be exact. Throws InputError if it cannot be.
bool is_exact(RankMethod method, std::size_t m, std::size_t n);

/// Ranks a sample (statistics/summary.h), the smallest value first.
Ranks ranks(std::span<const double> sample);

/// Ranks as whole numbers, ascending: doubled, since the mean rank of an even number of equal values ends in a half.
std::vector<std::size_t> doubled(const Ranks &ranks);

} // namespace planula
