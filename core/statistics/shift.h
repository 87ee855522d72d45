// SPDX-License-Identifier: MIT
// By how much one sample lies above another, in the unit of the values: the estimate of Hodges & Lehmann (1963), the
// median of all differences, with the interval of all shifts that the rank test does not reject (Hollander & Wolfe
// 1999, §3.3 and 4.3). Without ties it is that of R's wilcox.test(conf.int = TRUE, exact = TRUE); with ties the
// interval covers at least as often as stated (Noether 1967), where R approximates.
#pragma once

#include "statistics/summary.h"

#include <optional>
#include <span>

namespace planula {

struct Shift {
    double estimate;
    std::optional<Interval> interval; // none if so few values cannot give this confidence
};

/// Of two independent samples: the median of all a[i] - b[j]; rank_sum() of the samples. `confidence` in (0, 1).
Shift shift(std::span<const double> a, std::span<const double> b, double confidence);

/// Of pairs: the median of the means of all two differences d[i], d[j], i <= j, with d[i] = a[i] - b[i]; signed_rank()
/// of the samples.
Shift paired_shift(std::span<const double> a, std::span<const double> b, double confidence);

} // namespace planula
