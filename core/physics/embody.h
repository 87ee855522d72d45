// SPDX-License-Identifier: MIT
// From a body to a soft body in its world (§2.5).
#pragma once

#include "body/body.h"
#include "physics/environment.h"
#include "physics/soft_body.h"

namespace planula {

/// Places the body with its developed orientation: with ground, its centre of mass at x = 0 and its lowest
/// node on the ground; without, its centre of mass at the origin.
SoftBodyModel embody(const Body &body, const Environment &environment, const BodyParameters &parameters,
                     double time_step);

} // namespace planula
