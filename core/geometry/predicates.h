// SPDX-License-Identifier: MIT
// Exact signs of determinants of points' coordinates, by CGAL (filtered: floating point first, exact numbers in doubt).
#pragma once

#include "base/vec2.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace planula::exact {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Face = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
using Point = Kernel::Point_2;

inline Point point(Vec2d p) { return {p.x, p.y}; }

/// 1 if a, b, c turn left, -1 if they turn right, 0 if they lie on one line.
inline int turn(Vec2d a, Vec2d b, Vec2d c) {
    return static_cast<int>(CGAL::orientation(point(a), point(b), point(c)));
}

/// Whether p lies in the circle through a, b, c (counter-clockwise). Where four points share a circle CGAL's symbolic
/// perturbation decides, lexicographic by x, then y.
inline bool in_circle(Vec2d a, Vec2d b, Vec2d c, Vec2d p) {
    const auto side = CGAL::side_of_oriented_circle(point(a), point(b), point(c), point(p));
    if (side != CGAL::ON_ORIENTED_BOUNDARY) return side == CGAL::ON_POSITIVE_SIDE;
    static const Delaunay ties;
    return ties.side_of_oriented_circle(point(a), point(b), point(c), point(p), true) ==
           CGAL::ON_POSITIVE_SIDE;
}

} // namespace planula::exact
