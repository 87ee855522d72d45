// SPDX-License-Identifier: MIT
#include "geometry/delaunay.h"

#include "base/check.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <utility>

namespace planula {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

} // namespace

Triangulation delaunay(std::span<const Vec2d> points) {
    std::vector<std::pair<Kernel::Point_2, int>> indexed;
    for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(is_finite(points[i]), points[i].x, points[i].y);
        indexed.emplace_back(Kernel::Point_2(points[i].x, points[i].y), static_cast<int>(i));
    }
    const Delaunay mesh(indexed.begin(), indexed.end());
    CHECK(mesh.number_of_vertices() == points.size(), mesh.number_of_vertices(), points.size());

    // Edges and faces with indices instead of handles, in one order for all.
    Triangulation result;
    for (auto edge = mesh.finite_edges_begin(); edge != mesh.finite_edges_end(); ++edge) {
        const int a = edge->first->vertex(mesh.cw(edge->second))->info();
        const int b = edge->first->vertex(mesh.ccw(edge->second))->info();
        result.edges.push_back({std::min(a, b), std::max(a, b)});
    }
    for (auto face = mesh.finite_faces_begin(); face != mesh.finite_faces_end(); ++face) {
        std::array<int, 3> corners{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        result.faces.push_back(corners);
    }
    std::sort(result.edges.begin(), result.edges.end());
    std::sort(result.faces.begin(), result.faces.end());
    return result;
}

} // namespace planula
