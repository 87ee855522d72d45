// SPDX-License-Identifier: MIT
#include "body/connect.h"

#include "geometry/components.h"

#include <algorithm>
#include <utility>

namespace planula {

namespace {

/// Which edges are no longer than the limit.
std::vector<char> short_edges(const Edges &edges, std::span<const Vec2d> positions, double limit) {
    std::vector<char> result;
    result.reserve(edges.size());
    for (const auto &[a, b] : edges)
        result.push_back(squared_length(positions[b] - positions[a]) <= limit * limit);
    return result;
}

/// The links: all short edges; then, shortest first, each longer one whose ends are not yet connected.
std::vector<Link> links_of(const Edges &edges, std::span<const char> is_short,
                           std::span<const Vec2d> positions) {
    Components components(static_cast<int>(positions.size()));
    std::vector<Link> links;
    links.reserve(edges.size());
    std::vector<std::pair<double, Link>> longer;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const auto [a, b] = edges[i];
        if (!is_short[i]) {
            longer.push_back({squared_length(positions[b] - positions[a]), {a, b}});
            continue;
        }
        links.push_back({a, b});
        components.join(a, b);
    }
    if (components.count() == 1) return links;
    std::sort(longer.begin(), longer.end());
    for (const auto &[squared, link] : longer)
        if (components.join(link.a, link.b)) links.push_back(link);
    std::sort(links.begin(), links.end());
    return links;
}

/// The triangles whose three links are kept.
std::vector<Triangle> linked_of(const Triangles &all, std::span<const Link> links, std::size_t cells) {
    std::vector<bool> linked(cells * cells);
    for (const auto &[a, b] : links) linked[a * cells + b] = linked[b * cells + a] = true;
    std::vector<Triangle> triangles;
    for (const auto &[a, b, c] : all)
        if (linked[a * cells + b] && linked[b * cells + c] && linked[c * cells + a])
            triangles.push_back({a, b, c});
    return triangles;
}

} // namespace

Mesh connect(std::span<const Vec2d> positions, double limit) {
    const Triangulation full = delaunay(positions);
    Mesh mesh{.links = links_of(full.edges, short_edges(full.edges, positions, limit), positions)};
    mesh.triangles = linked_of(full.triangles, mesh.links, positions.size());
    return mesh;
}

void Connection::start(std::span<const Vec2d> positions) {
    delaunay_.start(positions);
    connect_all(positions);
}

bool Connection::follow(std::span<const Vec2d> positions) {
    if (!delaunay_.follow(positions)) return false;

    // Longer links depend on all lengths; without them links change only with the set of short edges.
    changed_ =
        delaunay_.has_changed() || !all_short_ || short_ != short_edges(delaunay_.edges(), positions, limit_);
    if (changed_) connect_all(positions);
    return true;
}

void Connection::connect_all(std::span<const Vec2d> positions) {
    short_ = short_edges(delaunay_.edges(), positions, limit_);
    links_ = links_of(delaunay_.edges(), short_, positions);
    all_short_ = static_cast<std::size_t>(std::count(short_.begin(), short_.end(), 1)) == links_.size();
    cells_ = positions.size();
    changed_ = true;
}

Mesh Connection::mesh() const { return {links_, linked_of(delaunay_.triangles(), links_, cells_)}; }

bool has_coincident_points(std::span<const Vec2d> positions) {
    std::vector<std::pair<double, double>> sorted;
    for (const Vec2d p : positions) sorted.push_back({p.x, p.y});
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

} // namespace planula
