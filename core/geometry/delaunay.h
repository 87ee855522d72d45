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

using Edges = std::vector<std::array<int, 2>>;     // low index first, ascending
using Triangles = std::vector<std::array<int, 3>>; // counter-clockwise, lowest index first, ascending

struct Triangulation {
    Edges edges;
    Triangles triangles;
};

/// One point: nothing; two: one edge; collinear points: the chain along their line. Points must be finite and
/// pairwise different (InternalError otherwise: CGAL would silently lose a vertex).
Triangulation delaunay(std::span<const Vec2d> points);

/// A face and those around it. Outside the hull each of its edges makes a face with a point at infinity.
struct Face {
    std::array<int, 3> corner; // counter-clockwise; infinity: the point at infinity
    std::array<int, 3> beyond; // the face across the edge opposite to each corner

    static constexpr int infinity = -1;
};

/// All faces of delaunay(), in any order; none if the points lie on one line.
std::vector<Face> delaunay_faces(std::span<const Vec2d> points);

/// The edges of `points` points, and the faces that are not to infinity.
Edges edges_of(std::span<const Face> faces, std::size_t points);
Triangles triangles_of(std::span<const Face> faces, std::size_t points);

} // namespace planula
