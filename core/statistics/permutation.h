// SPDX-License-Identifier: MIT
// The two-sided permutation test of the difference of two means (Pitman 1937; Good 2005, chapter 3): if the samples do
// not differ, every way to share their values out is equally likely. Whatever the values are, p is at most 0.05 in at
// most one case of twenty then. Used on one number for each run, the mean of its curve (Figs. 6, 7).
#pragma once

#include <cstdint>
#include <span>

namespace planula {

struct Shuffling {
    int draws; // at least 1
    std::uint64_t seed;
    std::uint32_t key; // which test this is
};

struct Permutation {
    double difference; // mean of a less mean of b
    double p;          // two-sided
    double least;      // the smallest p that these values can give
    bool exact;        // whether all ways were counted
};

/// If there are at most `draws` ways to share the values out, all are counted. Else that many are drawn from the stream
/// (seed; key, 0, permutation), and the one at hand counts with them. Samples are those of statistics/summary.h.
Permutation permutation_test(std::span<const double> a, std::span<const double> b,
                             const Shuffling &shuffling);

/// The same for pairs (Fisher 1935, §21): if the samples do not differ, each difference a[i] - b[i] is equally likely
/// to have either sign. If there are at most `draws` ways to choose the signs, all are counted; else they are drawn.
Permutation paired_permutation_test(std::span<const double> a, std::span<const double> b,
                                    const Shuffling &shuffling);

} // namespace planula
