// SPDX-License-Identifier: MIT
// The two-sided Wilcoxon rank-sum (Mann–Whitney) test of the paper's comparisons (§3.2, 3.3;
// decision 0015), with the conventions of R's wilcox.test.
#pragma once

#include <span>

namespace planula {

enum class RankSumMethod {
    automatic, // exact if both samples are smaller than 50 and there are no ties, else normal
    exact,     // exact unless there are ties
    normal     // normal approximation, corrected for ties and for continuity
};

struct RankSum {
    double statistic; // pairs in which a exceeds b, ties counting half: R's W, Mann and Whitney's U
    double p;         // two-sided
    bool exact;       // whether p is exact
};

/// Compares two samples (statistics/summary.h). If all values are equal, p is 1: nothing speaks for a
/// difference.
RankSum rank_sum(std::span<const double> a, std::span<const double> b,
                 RankSumMethod method = RankSumMethod::automatic);

} // namespace planula
