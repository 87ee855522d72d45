// SPDX-License-Identifier: MIT
// The inputs of a cell's network (§2.2; rule N1): where it is, directly and through four maternal morphogens, the
// morphogen outputs of its neighbours, and the time. Positions are in the development frame.
#pragma once

#include "base/portable.h"
#include "base/vec2.h"
#include "cell/channels.h"
#include "parameters/parameters.h"

#include <array>
#include <span>

namespace planula {

/// The nine inputs. `morphogen` is the mean of the neighbours' morphogen outputs, `time` runs from 0 to 1.
std::array<double, input::count> sense(Vec2d position, double morphogen, double time,
                                       const NetworkParameters &parameters);

/// Mean of morphogens[i] over the neighbours, in ascending order; 0 without neighbours.
PORTABLE inline double mean_morphogen(std::span<const int> neighbours, std::span<const double> morphogens) {
    double sum = 0;
    for (const int neighbour : neighbours) sum += morphogens[neighbour];
    return neighbours.empty() ? 0 : sum / static_cast<double>(neighbours.size());
}

} // namespace planula
