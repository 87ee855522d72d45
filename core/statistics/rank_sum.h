// SPDX-License-Identifier: MIT
// The two-sided Wilcoxon rank-sum (Mann–Whitney) test of the paper's comparisons (§3.2, 3.3; decision 0015). Without
// ties it is R's wilcox.test; with ties small samples are tested exactly as well, as by coin::wilcox_test(distribution
// = "exact"): given the values, every way to share them out is equally likely. The samples are taken as independent.
#pragma once

#include "statistics/ranks.h"

#include <span>

namespace planula {

struct RankSum {
    double statistic; // pairs in which a exceeds b, ties counting half: R's W, Mann and Whitney's U
    double p;         // two-sided: the probability of a statistic at least as far from its mean
    double least;     // the smallest p that these values can give, however they are shared out
    bool exact;       // whether p is exact
};

/// Compares two samples (statistics/summary.h). If all values are equal, p is 1.
RankSum rank_sum(std::span<const double> a, std::span<const double> b,
                 RankMethod method = RankMethod::automatic);

} // namespace planula
