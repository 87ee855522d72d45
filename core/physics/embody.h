// SPDX-License-Identifier: MIT
// From a body to a soft body in its world (§2.5).
#pragma once

#include "body/body.h"
#include "physics/environment.h"
#include "physics/soft_body.h"

namespace planula {

/// How much higher than the ground a body is placed where there are walls, cells.
inline constexpr double clearance_of_walls = 1e-3;

/// Places the body with its developed orientation: with ground, its centre of mass at x = 0 and its lowest
/// node on the ground (a thousandth of a cell above it if the environment has walls); without, its centre of mass at
/// the origin. The loose object follows, if there is one.
SoftBodyModel embody(const Body &body, const Environment &environment, const BodyParameters &parameters,
                     double time_step);

} // namespace planula
