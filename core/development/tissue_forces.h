// SPDX-License-Identifier: MIT
// The physics of an embryo: disks on damped springs in a viscous fluid (§2.1; rules D6 to D8).
#pragma once

#include "development/embryo.h"
#include "parameters/parameters.h"

#include <vector>

namespace planula {

/// The force on each cell: along every link k(l − L) + c·dl/dt with L the sum of the radii, and −γv.
/// Coincident cells do not push each other.
std::vector<Vec2d> tissue_forces(const Embryo &embryo, const DevelopmentParameters &parameters);

/// One step of semi-implicit Euler with the speed clamped to cell_speed_limit.
void relax(const DevelopmentParameters &parameters, Embryo &embryo);

} // namespace planula
