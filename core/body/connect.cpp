// SPDX-License-Identifier: MIT
#include "body/connect.h"

#include "geometry/components.h"
#include "geometry/delaunay.h"

#include <algorithm>
#include <utility>

namespace planula {

Mesh connect(std::span<const Vec2d> positions, double limit) {
    const Triangulation full = delaunay(positions);

    // Short links are all kept; the longer ones wait, shortest first.
    Mesh mesh;
    Components components(static_cast<int>(positions.size()));
    std::vector<std::pair<double, Link>> longer;
    for (const auto &[a, b] : full.edges) {
        const double squared = squared_length(positions[b] - positions[a]);
        if (squared <= limit * limit) {
            mesh.links.push_back({a, b});
            components.join(a, b);
        } else {
            longer.push_back({squared, {a, b}});
        }
    }
    std::sort(longer.begin(), longer.end());
    for (const auto &[squared, link] : longer)
        if (components.join(link.a, link.b)) mesh.links.push_back(link);
    std::sort(mesh.links.begin(), mesh.links.end());

    // A face survives with its links.
    const auto kept = [&](int a, int b) {
        return std::binary_search(mesh.links.begin(), mesh.links.end(), Link{std::min(a, b), std::max(a, b)});
    };
    for (const auto &[a, b, c] : full.faces)
        if (kept(a, b) && kept(b, c) && kept(c, a)) mesh.triangles.push_back({a, b, c});
    return mesh;
}

bool has_coincident_points(std::span<const Vec2d> positions) {
    std::vector<std::pair<double, double>> sorted;
    for (const Vec2d p : positions) sorted.push_back({p.x, p.y});
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

} // namespace planula
