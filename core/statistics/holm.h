// SPDX-License-Identifier: MIT
// p-values of many tests, corrected so that the probability of one or more false rejections among all of them is at
// most the significance, however the tests depend on each other (Holm 1979).
#pragma once

#include <span>
#include <vector>

namespace planula {

/// The corrected p-values, in the order given: R's p.adjust(p, "holm"). Each lies in [0, 1].
std::vector<double> holm(std::span<const double> p);

} // namespace planula
