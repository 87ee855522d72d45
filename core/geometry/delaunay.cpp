// SPDX-License-Identifier: MIT
#include "geometry/delaunay.h"

#include "base/check.h"
#include "base/counting_sort.h"
#include "geometry/predicates.h"

#include <algorithm>
#include <utility>

namespace planula {

namespace {

exact::Delaunay triangulated(std::span<const Vec2d> points) {
    std::vector<std::pair<exact::Point, int>> indexed;
    indexed.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        CHECK(is_finite(points[i]), points[i].x, points[i].y);
        indexed.emplace_back(exact::point(points[i]), static_cast<int>(i));
    }
    exact::Delaunay mesh(indexed.begin(), indexed.end());
    CHECK(mesh.number_of_vertices() == points.size(), mesh.number_of_vertices(), points.size());
    mesh.infinite_vertex()->info() = Face::infinity;
    return mesh;
}

std::vector<Face> faces_of(exact::Delaunay &mesh) {
    if (mesh.dimension() < 2) return {};
    int count = 0;
    for (const auto face : mesh.all_face_handles()) face->info() = count++;
    std::vector<Face> faces;
    faces.reserve(static_cast<std::size_t>(count));
    for (const auto face : mesh.all_face_handles()) {
        Face &copy = faces.emplace_back();
        for (int i = 0; i < 3; ++i)
            copy.corner[i] = face->vertex(i)->info(), copy.beyond[i] = face->neighbor(i)->info();
    }
    return faces;
}

/// The edges of points on one line.
Edges chain(const exact::Delaunay &mesh) {
    Edges edges;
    if (mesh.dimension() < 1) return edges;
    for (const auto &[face, i] : mesh.finite_edges()) {
        const int a = face->vertex(0)->info(), b = face->vertex(1)->info();
        edges.push_back({std::min(a, b), std::max(a, b)});
    }
    std::sort(edges.begin(), edges.end());
    return edges;
}

} // namespace

Triangulation delaunay(std::span<const Vec2d> points) {
    exact::Delaunay mesh = triangulated(points);
    if (mesh.dimension() < 2) return {chain(mesh), {}};
    const std::vector<Face> faces = faces_of(mesh);
    return {edges_of(faces, points.size()), triangles_of(faces, points.size())};
}

std::vector<Face> delaunay_faces(std::span<const Vec2d> points) {
    exact::Delaunay mesh = triangulated(points);
    return faces_of(mesh);
}

Edges edges_of(std::span<const Face> faces, std::size_t points) {
    // An edge goes up in one of its faces and down in the other. All sides are written, those that go up kept.
    Edges edges(3 * faces.size() + 1);
    std::size_t count = 0;
    for (const auto &[corner, beyond] : faces)
        for (int i = 0; i < 3; ++i) {
            const int from = corner[i], to = corner[(i + 1) % 3];
            edges[count] = {from, to};
            count += static_cast<std::size_t>((0 <= from) & (from < to));
        }
    edges.resize(count);
    counting_sort(edges, static_cast<int>(points));
    return edges;
}

Triangles triangles_of(std::span<const Face> faces, std::size_t points) {
    Triangles triangles;
    for (const auto &[corner, beyond] : faces) {
        const auto [a, b, c] = corner;
        const int low = std::min({a, b, c});
        if (low >= 0)
            triangles.push_back(low == a ? corner : low == b ? std::array{b, c, a} : std::array{c, a, b});
    }
    counting_sort(triangles, static_cast<int>(points));
    return triangles;
}

} // namespace planula
