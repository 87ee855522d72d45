// SPDX-License-Identifier: MIT
#include "geometry/delaunay.h"

#include "base/check.h"
#include "geometry/predicates.h"

#include <algorithm>
#include <numeric>
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

/// All that visit() shows to its argument, ascending; their first numbers are below `bins`.
template <class Item, class Visit> std::vector<Item> in_order(std::size_t bins, const Visit &visit) {
    // Counted, then put into bins by their first number, each from its end.
    std::vector<int> first(bins + 1);
    visit([&](const Item &item) { ++first[item[0]]; });
    std::partial_sum(first.begin(), first.end(), first.begin());
    std::vector<Item> items(static_cast<std::size_t>(first.back()));
    visit([&](const Item &item) { items[--first[item[0]]] = item; });
    for (std::size_t bin = 0; bin < bins; ++bin)
        std::sort(items.begin() + first[bin], items.begin() + first[bin + 1]);
    return items;
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
    return in_order<Edges::value_type>(points, [&](const auto &show) {
        // An edge goes up in one of its faces and down in the other.
        for (const auto &[corner, beyond] : faces) {
            const auto [a, b, c] = corner;
            if (0 <= a && a < b) show({a, b});
            if (0 <= b && b < c) show({b, c});
            if (0 <= c && c < a) show({c, a});
        }
    });
}

Triangles triangles_of(std::span<const Face> faces, std::size_t points) {
    return in_order<Triangles::value_type>(points, [&](const auto &show) {
        for (const auto &[corner, beyond] : faces) {
            const auto [a, b, c] = corner;
            const int low = std::min({a, b, c});
            if (low >= 0) show(low == a ? corner : low == b ? std::array{b, c, a} : std::array{c, a, b});
        }
    });
}

} // namespace planula
