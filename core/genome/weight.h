// SPDX-License-Identifier: MIT
// The weights that genomes may have (rule E3 of the article).
#pragma once

#include <cmath>

namespace planula {

/// The nearest multiple of the step, of two the higher; the weight itself if the step is 0. Exact if the step is a
/// power of two.
inline double rounded_weight(double weight, double step) {
    return step > 0 ? std::floor(weight / step + 0.5) * step : weight;
}

} // namespace planula
