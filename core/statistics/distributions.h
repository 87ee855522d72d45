// SPDX-License-Identifier: MIT
// Probabilities of the normal distribution and of Student's t, and the distributions of sums of ranks if two samples do
// not differ.
#pragma once

#include <cstddef>
#include <vector>

namespace planula {

/// P(Z <= z) of the standard normal distribution; relative error below 1e-12.
double normal_below(double z);

/// The z with P(Z <= z) = p, for p in (0, 1); error below 1e-10.
double normal_quantile(double p);

/// P(|T| >= |t|) for Student's t with `freedom` degrees of freedom, at least 1: the two-sided p.
double student_beyond(double t, int freedom);

/// The number of ways to choose m of the ranks, which ascend, by their sum: count[s] have sum s. All ways are equally
/// likely if two samples do not differ, whatever ties there are.
std::vector<double> ways_to_sum(const std::vector<std::size_t> &ranks, std::size_t m);

/// The probability of each sum of the ranks with a positive sign, if all signs are equally likely.
std::vector<double> chances_of_signed_sums(const std::vector<std::size_t> &ranks);

} // namespace planula
