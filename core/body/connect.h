// SPDX-License-Identifier: MIT
// The neighbourhood of cells, in embryos and bodies alike (§2.1; MODEL D7, D7a): the Delaunay triangulation
// without links longer than 150 % of a cell diameter, except where such a link holds the body together.
#pragma once

#include "body/mesh.h"

namespace planula {

/// Links: all of length <= `limit`; then, in ascending order of length (ties by index), each longer Delaunay
/// link whose ends are not yet connected. Triangles: the Delaunay faces whose three links all survive.
/// Positions must be finite and pairwise different; check with has_coincident_points.
Mesh connect(std::span<const Vec2d> positions, double limit);

/// Whether two points have equal coordinates, so that no triangulation has a place for both.
bool has_coincident_points(std::span<const Vec2d> positions);

} // namespace planula
