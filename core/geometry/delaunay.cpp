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

/// Indices packed into one number, in whose order they are sorted: the first counts most.
constexpr int digit_bits = 21;
int digit(std::uint64_t key, int place) {
    return static_cast<int>(key >> (place * digit_bits) & ((1u << digit_bits) - 1));
}
std::uint64_t pack(int a, int b) { return static_cast<std::uint64_t>(a) << digit_bits | b; }

/// Edges and faces with indices instead of handles, in one order for all.
Triangulation indexed(const Delaunay &mesh) {
    CHECK(mesh.number_of_vertices() < 1u << digit_bits);
    std::vector<std::uint64_t> edges, faces;
    edges.reserve(3 * mesh.number_of_vertices()), faces.reserve(2 * mesh.number_of_vertices());
    for (auto edge = mesh.finite_edges_begin(); edge != mesh.finite_edges_end(); ++edge) {
        const int a = edge->first->vertex(mesh.cw(edge->second))->info();
        const int b = edge->first->vertex(mesh.ccw(edge->second))->info();
        edges.push_back(pack(std::min(a, b), std::max(a, b)));
    }
    for (auto face = mesh.finite_faces_begin(); face != mesh.finite_faces_end(); ++face) {
        std::array<int, 3> corners{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        faces.push_back(pack(corners[0], corners[1]) << digit_bits | corners[2]);
    }

    std::sort(edges.begin(), edges.end());
    std::sort(faces.begin(), faces.end());
    Triangulation result;
    result.edges.reserve(edges.size()), result.faces.reserve(faces.size());
    for (const auto key : edges) result.edges.push_back({digit(key, 1), digit(key, 0)});
    for (const auto key : faces) result.faces.push_back({digit(key, 2), digit(key, 1), digit(key, 0)});
    return result;
}

/// Exchanges the edge opposite to corner i of a face for the other diagonal; its ends may be the point at infinity.
/// False if they are linked already.
bool exchange(Delaunay &mesh, Delaunay::Face_handle face, int i) {
    const auto beyond = face->neighbor(i)->vertex(mesh.mirror_index(face, i));
    if (mesh.tds().is_edge(face->vertex(i), beyond)) return false;
    mesh.tds().flip(face, i);
    return true;
}

/// The corner opposite to the longest edge: if a face has turned over, that is the edge it has crossed.
int crossing_corner(const Delaunay &mesh, Delaunay::Face_handle face) {
    std::array<double, 3> squared;
    for (int i = 0; i < 3; ++i) squared[i] = mesh.segment(face, i).squared_length();
    return static_cast<int>(std::max_element(squared.begin(), squared.end()) - squared.begin());
}

/// What became of a triangulation whose points have moved.
enum class Motion { harmless, mended, lost };

/// Exchanges edges that a corner has crossed. Says whether there were none.
Motion mend_faces(Delaunay &mesh) {
    Motion motion = Motion::harmless;
    for (auto face = mesh.finite_faces_begin(); face != mesh.finite_faces_end(); ++face) {
        if (mesh.triangle(face).orientation() == CGAL::COUNTERCLOCKWISE) continue;
        if (!exchange(mesh, face, crossing_corner(mesh, face))) return Motion::lost;
        motion = Motion::mended;
    }
    return motion;
}

/// Fills the corners at which the hull turns inwards. Says whether there were none.
Motion mend_hull(Delaunay &mesh) {
    Motion motion = Motion::harmless;
    int eastmost = 0;
    const auto infinite = mesh.infinite_vertex();
    auto face = infinite->face();
    for (auto left = mesh.tds().degree(infinite); left > 0; --left) {
        // Three points in turn, clockwise.
        const int i = face->index(infinite);
        const auto next = face->neighbor(Delaunay::ccw(i));
        const Point &first = face->vertex(Delaunay::ccw(i))->point(),
                    &second = face->vertex(Delaunay::cw(i))->point(),
                    &third = next->vertex(Delaunay::cw(next->index(infinite)))->point();
        if (CGAL::orientation(first, second, third) == CGAL::LEFT_TURN) {
            if (!exchange(mesh, face, Delaunay::ccw(i))) return Motion::lost;
            motion = Motion::mended;
        }
        eastmost += first < second && third < second;
        face = next;
    }
    return motion == Motion::harmless && eastmost != 1 ? Motion::lost : motion;
}

/// Exchanges edges until all faces are counter-clockwise inside a hull that turns nowhere inwards and goes round once:
/// then it is a triangulation.
Motion straighten(Delaunay &mesh) {
    constexpr int attempts = 8;
    for (int i = 0; i < attempts; ++i) {
        const Motion faces = mend_faces(mesh);
        const Motion hull = faces == Motion::lost ? faces : mend_hull(mesh);
        if (hull == Motion::lost) return hull;
        if (faces == Motion::harmless && hull == Motion::harmless) return i == 0 ? hull : Motion::mended;
    }
    return Motion::lost;
}

/// Flips edges until each face's circle holds no corner of its neighbours, ties broken as by insertion (Lawson
/// 1977). Returns whether any was flipped.
bool make_delaunay(Delaunay &mesh) {
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
    auto &[mesh, vertices] = *mesh_;
    CHECK(points.size() >= vertices.size(), points.size(), vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) vertices[i]->set_point(Point(points[i].x, points[i].y));
    const Motion motion = straighten(mesh);
    if (motion == Motion::lost) return false;
    changed_ = make_delaunay(mesh) || motion == Motion::mended;

    // New points, one by one; the last one's face is near the next as likely as any.
    for (std::size_t i = vertices.size(); i < points.size(); ++i) {
        const auto vertex = mesh.insert(Point(points[i].x, points[i].y), vertices.back()->face());
        if (mesh.number_of_vertices() != i + 1) return false;
        vertex->info() = static_cast<int>(i);
        vertices.push_back(vertex);
        changed_ = true;
    }
    if (changed_) now_ = indexed(mesh);
    return true;
}

} // namespace planula
