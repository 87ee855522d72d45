// SPDX-License-Identifier: MIT
// The Wilcoxon signed-rank test of pairs (Wilcoxon 1945), such as runs of two settings with the same seed: whether the
// differences a[i] - b[i] are symmetric about 0. Pairs without a difference are dropped, as in R. Without these and
// without ties it is R's wilcox.test(a, b, paired = TRUE); with either of them few pairs are tested exactly as well, as
// by coin::wilcoxsign_test(zero.method = "Wilcoxon", distribution = "exact"): given the sizes of the differences, all
// their signs are equally likely.
#pragma once

#include "statistics/ranks.h"

#include <span>

namespace planula {

struct SignedRank {
    double statistic = 0;        // R's V: the sum of the ranks of the positive differences
    double p = 1;                // two-sided
    double greater = 1;          // one-sided: of a sum at least as large, small if a exceeds b
    double less = 1;             // one-sided: of a sum at most as large
    double least = 1;            // the smallest two-sided p that so many differences can give
    bool exact = true;           // whether p is exact
    std::size_t differences = 0; // that are not 0, and were ranked; without any, every p is 1
};

/// Compares the pairs of two samples (statistics/summary.h).
SignedRank signed_rank(std::span<const double> a, std::span<const double> b,
                       RankMethod method = RankMethod::automatic);

} // namespace planula
