// SPDX-License-Identifier: MIT
#include "geometry/delaunay.h"

#include "base/check.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace planula {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

using Point = Kernel::Point_2;

Delaunay triangulated(std::span<const Vec2d> points) {
    std::vector<std::pair<Point, int>> indexed;
    indexed.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(is_finite(points[i]), points[i].x, points[i].y);
        indexed.emplace_back(Point(points[i].x, points[i].y), static_cast<int>(i));
    }
    Delaunay mesh(indexed.begin(), indexed.end());
    CHECK(mesh.number_of_vertices() == points.size(), mesh.number_of_vertices(), points.size());
    return mesh;
}

/// Edges and faces with indices instead of handles, in one order for all. Indices are packed into one number
/// while they are sorted.
Triangulation indexed(const Delaunay &mesh) {
    constexpr std::uint64_t base = std::uint64_t{1} << 21;
    const auto unpacked = [](std::uint64_t key, int digit) {
        for (int i = 0; i < digit; ++i) key /= base;
        return static_cast<int>(key % base);
    };
    CHECK(mesh.number_of_vertices() < base);
    Triangulation result;
    std::vector<std::uint64_t> keys;
    for (auto edge = mesh.finite_edges_begin(); edge != mesh.finite_edges_end(); ++edge) {
        const int a = edge->first->vertex(mesh.cw(edge->second))->info();
        const int b = edge->first->vertex(mesh.ccw(edge->second))->info();
        keys.push_back(std::min(a, b) * base + std::max(a, b));
    }
    std::sort(keys.begin(), keys.end());
    result.edges.reserve(keys.size());
    for (const std::uint64_t key : keys) result.edges.push_back({unpacked(key, 1), unpacked(key, 0)});

    keys.clear();
    for (auto face = mesh.finite_faces_begin(); face != mesh.finite_faces_end(); ++face) {
        std::array<int, 3> corners{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        keys.push_back((corners[0] * base + corners[1]) * base + corners[2]);
    }
    std::sort(keys.begin(), keys.end());
    result.faces.reserve(keys.size());
    for (const std::uint64_t key : keys)
        result.faces.push_back({unpacked(key, 2), unpacked(key, 1), unpacked(key, 0)});
    return result;
}

/// Whether all faces are counter-clockwise and the hull turns nowhere inwards: then it is a triangulation.
bool is_plane(const Delaunay &mesh) {
    for (auto face = mesh.finite_faces_begin(); face != mesh.finite_faces_end(); ++face)
        if (mesh.triangle(face).orientation() != CGAL::COUNTERCLOCKWISE) return false;

    // The circulator goes round the outside, so clockwise.
    const auto start = mesh.incident_vertices(mesh.infinite_vertex());
    auto first = start;
    do {
        auto second = first, third = ++second;
        if (CGAL::orientation(first->point(), second->point(), (++third)->point()) == CGAL::LEFT_TURN)
            return false;
    } while (++first != start);
    return true;
}

/// Flips edges until each face's circle holds no corner of its neighbours, ties broken as by insertion (Lawson
/// 1977). Returns whether any was flipped.
bool mend(Delaunay &mesh) {
    bool flipped = false;
    for (bool again = true; again;) {
        again = false;
        for (auto edge = mesh.finite_edges_begin(); edge != mesh.finite_edges_end(); ++edge) {
            const auto [face, i] = *edge;
            const auto other = face->neighbor(i);
            if (mesh.is_infinite(face) || mesh.is_infinite(other)) continue;
            const Point &opposite = other->vertex(mesh.mirror_index(face, i))->point();
            if (mesh.side_of_oriented_circle(face->vertex(0)->point(), face->vertex(1)->point(),
                                             face->vertex(2)->point(), opposite,
                                             true) != CGAL::ON_POSITIVE_SIDE)
                continue;
            mesh.flip(face, i);
            flipped = again = true;
        }
    }
    return flipped;
}

} // namespace

Triangulation delaunay(std::span<const Vec2d> points) { return indexed(triangulated(points)); }

struct MovingDelaunay::Mesh {
    Delaunay mesh;
    std::vector<Delaunay::Vertex_handle> vertices; // by index
};

MovingDelaunay::MovingDelaunay() = default;
MovingDelaunay::~MovingDelaunay() = default;

void MovingDelaunay::start(std::span<const Vec2d> points) {
    mesh_ = std::make_unique<Mesh>(Mesh{triangulated(points), {}});
    mesh_->vertices.resize(points.size());
    for (auto vertex = mesh_->mesh.finite_vertices_begin(); vertex != mesh_->mesh.finite_vertices_end();
         ++vertex)
        mesh_->vertices[vertex->info()] = vertex;
    now_ = indexed(mesh_->mesh);
    changed_ = true;
}

bool MovingDelaunay::follow(std::span<const Vec2d> points) {
    if (!mesh_ || mesh_->mesh.dimension() != 2) return false;
    CHECK(points.size() == mesh_->vertices.size(), points.size(), mesh_->vertices.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        mesh_->vertices[i]->set_point(Point(points[i].x, points[i].y));
    if (!is_plane(mesh_->mesh)) return false;
    changed_ = mend(mesh_->mesh);
    if (changed_) now_ = indexed(mesh_->mesh);
    return true;
}

} // namespace planula
