// SPDX-License-Identifier: MIT
// Spearman's rank correlation: whether two engines put the same champions in the same order, with the
// conventions of R's cor(method = "spearman").
#pragma once

#include <optional>
#include <span>

namespace planula {

/// Spearman's rho of the pairs (a[i], b[i]): Pearson's correlation of their ranks, equal values sharing the
/// mean rank. Two samples of equal size (statistics/summary.h); none if all values of either are equal, as
/// those of a single pair are.
std::optional<double> rank_correlation(std::span<const double> a, std::span<const double> b);

struct RankCorrelation {
    double rho;
    double p;   // two-sided: of a rho at least as far from 0 if the pairs were made by chance
    bool exact; // whether p is exact
};

/// The same with its test. Of at most nine pairs every order is counted, with ties as well: without them, R's
/// cor.test(method = "spearman"). Of more pairs p is that of Student's t, as R's cor.test(exact = FALSE).
std::optional<RankCorrelation> rank_correlation_test(std::span<const double> a, std::span<const double> b);

} // namespace planula
