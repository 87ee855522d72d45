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
    mesh.infinite_vertex()->info() = -1;
    return mesh;
}

std::vector<Delaunay::Vertex_handle> vertices_of(const Delaunay &mesh) {
    std::vector<Delaunay::Vertex_handle> vertices(mesh.number_of_vertices());
    for (const auto vertex : mesh.finite_vertex_handles()) vertices[vertex->info()] = vertex;
    return vertices;
}

/// Edges and faces with indices instead of handles, in one order for all.
Triangulation indexed(const Delaunay &mesh, std::span<const Delaunay::Vertex_handle> vertices) {
    Triangulation result;
    result.edges.reserve(3 * vertices.size()), result.faces.reserve(2 * vertices.size());
    std::vector<std::array<int, 2>> spokes;
    for (int a = 0; a < static_cast<int>(vertices.size()) && mesh.dimension() > 0; ++a) {
        // Higher neighbours, each with the one that follows it counter-clockwise.
        spokes.clear();
        const auto start = mesh.incident_vertices(vertices[a]);
        auto neighbour = start;
        do {
            const int b = neighbour->info();
            ++neighbour;
            if (b > a) spokes.push_back({b, neighbour->info()});
        } while (neighbour != start);

        std::sort(spokes.begin(), spokes.end());
        for (const auto &[b, c] : spokes) {
            result.edges.push_back({a, b});
            if (c > a && mesh.dimension() == 2) result.faces.push_back({a, b, c});
        }
    }
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

/// Whether a corner of one face beside this edge lies in the circle of the other, ties broken as by insertion.
bool must_flip(const Delaunay &mesh, const Delaunay::Edge &edge) {
    const auto [face, i] = edge;
    const auto other = face->neighbor(i);
    if (mesh.is_infinite(face) || mesh.is_infinite(other)) return false;
    const Point &opposite = other->vertex(mesh.mirror_index(face, i))->point();
    return mesh.side_of_oriented_circle(face->vertex(0)->point(), face->vertex(1)->point(),
                                        face->vertex(2)->point(), opposite, true) == CGAL::ON_POSITIVE_SIDE;
}

/// Flips edges until none must be (Lawson 1977). Returns whether any was.
bool make_delaunay(Delaunay &mesh) {
    bool flipped = false;
    std::vector<Delaunay::Edge> suspects(mesh.finite_edges_begin(), mesh.finite_edges_end());
    while (!suspects.empty()) {
        const Delaunay::Edge edge = suspects.back();
        suspects.pop_back();
        if (!must_flip(mesh, edge)) continue;
        const auto face = edge.first, other = face->neighbor(edge.second);
        mesh.flip(face, edge.second);
        flipped = true;

        // The four edges around the flipped one. Those that stood for edges of these faces stand for some of them still.
        for (int i = 0; i < 3; ++i) {
            if (face->neighbor(i) != other) suspects.emplace_back(face, i);
            if (other->neighbor(i) != face) suspects.emplace_back(other, i);
        }
    }
    return flipped;
}

} // namespace

Triangulation delaunay(std::span<const Vec2d> points) {
    const Delaunay mesh = triangulated(points);
    return indexed(mesh, vertices_of(mesh));
}

struct MovingDelaunay::Mesh {
    Delaunay mesh;
    std::vector<Delaunay::Vertex_handle> vertices; // by index
};

MovingDelaunay::MovingDelaunay() = default;
MovingDelaunay::~MovingDelaunay() = default;

void MovingDelaunay::start(std::span<const Vec2d> points) {
    mesh_ = std::make_unique<Mesh>(Mesh{triangulated(points), {}});
    mesh_->vertices = vertices_of(mesh_->mesh);
    now_ = indexed(mesh_->mesh, mesh_->vertices);
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
    if (changed_) now_ = indexed(mesh, vertices);
    return true;
}

} // namespace planula
