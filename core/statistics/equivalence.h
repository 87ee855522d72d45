// SPDX-License-Identifier: MIT
// A test that two samples do not differ by more than a stated bound. That a test of a difference is not significant
// says nothing of the kind: few values never are. Two one-sided tests (Schuirmann 1987) of Vargha and Delaney's A12
// (statistics/effect_size.h), with the normal approximation. The standard deviation of A12 is the larger of the one it
// has if the samples do not differ, sqrt((m + n + 1) / (12 m n)), and of DeLong's estimate (DeLong et al. 1988), so
// that the test errs to the side of not concluding.
#pragma once

#include <span>

namespace planula {

struct Equivalence {
    double effect;    // A12
    double deviation; // its standard deviation
    double p;         // one-sided: small if A12 lies within 1/2 ± bound
    double least;     // the smallest p that this number of values can give
};

/// `bound` lies in (0, 1/2). The samples (statistics/summary.h) are taken as independent.
Equivalence equivalence(std::span<const double> a, std::span<const double> b, double bound);

/// The same for pairs: the larger p of two one-sided signed-rank tests (statistics/signed_rank.h), that the typical
/// difference a[i] - b[i] is above -bound and below bound, in the unit of the values; bound is above 0.
double paired_equivalence(std::span<const double> a, std::span<const double> b, double bound);

} // namespace planula
