// SPDX-License-Identifier: MIT
#include "body/mesh.h"

#include <algorithm>
#include <map>
#include <utility>

namespace planula {

namespace {

using HalfEdge = std::pair<int, int>;

/// Every half-edge of the triangles, each with the corner opposite to it.
std::map<HalfEdge, int> half_edges(const Mesh &mesh) {
    std::map<HalfEdge, int> apex;
    for (const auto &[a, b, c] : mesh.triangles) apex[{a, b}] = c, apex[{b, c}] = a, apex[{c, a}] = b;
    return apex;
}

} // namespace

std::vector<OutlineLink> outline(const Mesh &mesh) {
    // A link is inner if both its half-edges lie in triangles.
    const std::map<HalfEdge, int> apex = half_edges(mesh);
    std::vector<OutlineLink> links;
    for (const auto &[a, b] : mesh.links) {
        const bool forward = apex.contains({a, b}), backward = apex.contains({b, a});
        if (forward && backward) continue;
        links.push_back(backward ? OutlineLink{b, a, true} : OutlineLink{a, b, forward});
    }

    // The next link on a contour: turn about the end of this one, from triangle to triangle, until one has no
    // neighbour.
    std::map<HalfEdge, int> index;
    for (std::size_t i = 0; i < links.size(); ++i)
        if (links[i].solid) index[{links[i].a, links[i].b}] = static_cast<int>(i);
    for (auto &link : links) {
        if (!link.solid) continue;
        const int pivot = link.b;
        int corner = apex.at({link.a, pivot});
        while (apex.contains({corner, pivot})) corner = apex.at({corner, pivot});
        link.next = index.at({pivot, corner});
    }
    for (std::size_t i = 0; i < links.size(); ++i)
        if (links[i].solid) links[links[i].next].previous = static_cast<int>(i);
    return links;
}

std::vector<std::vector<int>> neighbours(const Mesh &mesh, int count) {
    std::vector<std::vector<int>> result(static_cast<std::size_t>(count));
    for (const auto &[a, b] : mesh.links) result[a].push_back(b), result[b].push_back(a);
    for (auto &list : result) std::sort(list.begin(), list.end());
    return result;
}

} // namespace planula
