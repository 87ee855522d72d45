// SPDX-License-Identifier: MIT
// Division and death (§2.3, 2.4; MODEL section 1).
#pragma once

#include "development/embryo.h"
#include "parameters/parameters.h"

#include <span>

namespace planula {

/// The direction in which a cell would divide: the circular mean of its neighbours' orientations, turned by
/// π · angle_output. Without neighbours, or if their orientations cancel, its own orientation is turned.
Vec2d division_direction(const Embryo &embryo, int cell, double angle_output);

/// Removes the marked cells (one mark per cell). Links are stale afterwards.
void remove_cells(std::span<const char> dying, Embryo &embryo);

/// The daughter's place: in contact with the mother, plus a fixed offset of at most division_jitter that
/// depends on the daughter's id alone and breaks exact collinearity.
Vec2d daughter_position(Vec2d mother, Vec2d direction, int daughter_id, const Parameters &parameters);

/// Divides one cell unless another centre lies within division_clearance of the daughter's place. The
/// daughter inherits velocity, activations and morphogen; both take the direction as orientation. Returns
/// whether it divided; a refused division changes nothing. Links are stale afterwards.
bool divide(int mother, Vec2d direction, const Parameters &parameters, Embryo &embryo);

} // namespace planula
