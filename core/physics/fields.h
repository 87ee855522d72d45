// SPDX-License-Identifier: MIT
// What acts on a body at a distance and is not the same everywhere and always (decision 0025): regions with another
// fluid, a current that changes with time, and gravity that is tilted or taken away by water.
#pragma once

#include "base/box.h"

#include <optional>
#include <vector>

namespace planula {

/// A part of the plane with another fluid. A link of the outline is in the first region that holds its middle.
struct Region {
    Box box;
    double drag_normal = 0, drag_tangential = 0;
    std::optional<Vec2d> flow; // none: that of the environment
    /// The share of gravity that it takes away from each cell in it; only of regions without sides. It acts on a cell
    /// in the first region that states a buoyancy and holds it.
    std::optional<double> buoyancy;
};

/// A velocity of the fluid that changes with time, as samples that are joined by straight lines.
struct Current {
    std::vector<Vec2d> samples; // cells/t.u.; empty: it does not change
    int step = 1;               // physics steps from one sample to the next
    bool repeats = false;       // after the last sample comes the first; else the last one holds

    bool changes() const { return !samples.empty(); }
    /// After so many steps, 0 or more; it must change.
    Vec2d at(double steps) const;
};

/// Gravity that is turned counter-clockwise from straight down, in degrees; of 0 degrees exactly (0, -gravity).
Vec2d gravity_vector(double gravity, double degrees);

struct Environment;
/// Throws InputError stating the rule and the value; see there.
void check_fields(const Environment &environment);

} // namespace planula
