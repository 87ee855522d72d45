// SPDX-License-Identifier: MIT
// A comparison of two settings in words: a few lines for a terminal, and the sentence that a paper would print.
#pragma once

#include "analysis/comparison.h"

#include <string>

namespace planula {

/// Medians, difference, effect size and p, a line each, with a heading.
std::string lines_of(const ComparisonRow &row, const Comparisons &comparisons, const ComparisonPlan &plan);

/// One sentence with all numbers that a reader needs, rounded.
std::string sentence_of(const ComparisonRow &row, const Comparisons &comparisons, const ComparisonPlan &plan);

/// "95 %", "99.5 %".
std::string percent_text(double share);

/// "p = 0.012", or "p < 0.0001".
std::string p_text(double p);

} // namespace planula
