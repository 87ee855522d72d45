// SPDX-License-Identifier: MIT
#include "body/mesh.h"

#include <algorithm>
#include <set>
#include <utility>

namespace planula {

namespace {

using HalfEdge = std::pair<int, int>;

std::set<HalfEdge> half_edges(const Mesh &mesh) {
    std::set<HalfEdge> edges;
    for (const auto &[a, b, c] : mesh.triangles) edges.insert({{a, b}, {b, c}, {c, a}});
    return edges;
}

} // namespace

std::vector<OutlineLink> outline(const Mesh &mesh) {
    // A link is inner if both its half-edges lie in triangles.
    const std::set<HalfEdge> edges = half_edges(mesh);
    std::vector<OutlineLink> links;
    for (const auto &[a, b] : mesh.links) {
        const bool forward = edges.contains({a, b}), backward = edges.contains({b, a});
        if (forward && backward) continue;
        links.push_back(backward ? OutlineLink{b, a, true} : OutlineLink{a, b, forward});
    }
    return links;
}

std::vector<std::vector<int>> neighbours(const Mesh &mesh, int count) {
    std::vector<std::vector<int>> result(static_cast<std::size_t>(count));
    for (const auto &[a, b] : mesh.links) result[a].push_back(b), result[b].push_back(a);
    for (auto &list : result) std::sort(list.begin(), list.end());
    return result;
}

} // namespace planula
