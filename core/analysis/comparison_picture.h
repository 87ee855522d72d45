// SPDX-License-Identifier: MIT
// A picture of compared settings by one measure, in shades of grey: a circle for each run, lines between runs of the
// same seed where these were compared as pairs, dashed where the value falls, and the median of each setting with its
// interval.
#pragma once

#include "analysis/comparison.h"

#include <string>

namespace planula {

/// The picture as SVG. On a logarithmic axis every value must be above 0, else throws InputError with the first that
/// is not.
std::string svg_of(const Comparisons &comparisons, const Measure &measure, bool logarithmic);

} // namespace planula
