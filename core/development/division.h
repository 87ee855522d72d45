// SPDX-License-Identifier: MIT
// Division and death (§2.3, 2.4; rules D10 to D18).
#pragma once

#include "development/embryo.h"
#include "parameters/parameters.h"

#include <span>

namespace planula {

/// The direction in which a cell would divide: the circular mean of its neighbours' orientations, turned by
/// π · division_angle_range · angle_output. Without neighbours, or if their orientations cancel, its own orientation
/// is turned.
Vec2d division_direction(const Embryo &embryo, int cell, double angle_output,
                         const DevelopmentParameters &parameters);

/// Turns every cell's orientation as its links have turned since the cells were at these places: by the rotation that
/// maps the links as they were onto the links as they are with the least squared error. Cells and links must be the
/// same as then. Cells without links keep their orientation.
void carry_orientations(std::span<const Vec2d> places, Embryo &embryo);

/// Removes the marked cells (one mark per cell). Links are stale afterwards.
void remove_cells(std::span<const char> dying, Embryo &embryo);

/// The lineage of the next daughter: a hash of the mother's and of how many she has. What happens elsewhere in the
/// embryo does not change it.
std::uint64_t daughter_lineage(const Cell &mother);

/// The daughter's place: in contact with the mother, plus a fixed offset of at most division_jitter that
/// depends on the daughter's lineage alone and breaks exact collinearity.
Vec2d daughter_position(Vec2d mother, Vec2d direction, std::uint64_t lineage,
                        const DevelopmentParameters &parameters);

/// Divides one cell unless another centre lies within division_clearance of the daughter's place. The
/// daughter inherits velocity, activations and morphogen, and the mother's orientation; the cells that division_turn
/// names take the direction as orientation. Returns whether it divided; a refused division changes nothing. Links are
/// stale afterwards.
bool divide(int mother, Vec2d direction, const DevelopmentParameters &parameters, Embryo &embryo);

} // namespace planula
