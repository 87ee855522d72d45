// SPDX-License-Identifier: MIT
// p-values of many tests, corrected so that among those called significant at most the stated share is expected to be
// false (Benjamini & Hochberg 1995): less strict than holm(), for tables of many comparisons that are looked at
// together. The tests are independent or positively dependent.
#pragma once

#include <span>
#include <vector>

namespace planula {

/// The corrected p-values, in the order given: R's p.adjust(p, "BH"). Each lies in [0, 1].
std::vector<double> benjamini_hochberg(std::span<const double> p);

} // namespace planula
