// SPDX-License-Identifier: MIT
// Delaunay triangulation of points in the plane, by CGAL's exact predicates (§2.1). The result is a function
// of the coordinates alone: cocircular ties are broken by CGAL's symbolic perturbation (lexicographic by x,
// then y), and edges and faces are sorted by index, because their order in CGAL depends on insertion.
#pragma once

#include "base/vec2.h"

#include <array>
#include <span>
#include <vector>

namespace planula {

struct Triangulation {
    std::vector<std::array<int, 2>> edges; // low index first, ascending
    std::vector<std::array<int, 3>> faces; // counter-clockwise, lowest index first, ascending
};

/// One point: nothing; two: one edge; collinear points: the chain along their line. Points must be finite and
/// pairwise different (InternalError otherwise: CGAL would silently lose a vertex).
Triangulation delaunay(std::span<const Vec2d> points);

} // namespace planula
