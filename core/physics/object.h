// SPDX-License-Identifier: MIT
// A loose object that an animat can push: cells without muscles on a triangular lattice, a cell apart, with the springs
// and pressure of an animat (decision 0024). Forces, ground and walls act on it as on the animat.
#pragma once

#include "body/body.h"

namespace planula {

/// Of these cells of the lattice. Throws InputError with the rule: 3 … 500 cells that hold together, all in triangles.
Body make_object(const std::vector<Vec2d> &cells);
/// The cells of the lattice inside a polygon, or on it, that is given relative to `at`, where one cell of the lattice
/// is.
Body make_object(Vec2d at, const std::vector<Vec2d> &shape);
/// The cells within a distance of `at`.
Body make_object(Vec2d at, double radius);

} // namespace planula
