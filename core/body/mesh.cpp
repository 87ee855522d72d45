// SPDX-License-Identifier: MIT
#include "body/mesh.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace planula {

namespace {

using HalfEdge = std::pair<int, int>;

/// The sides of all triangles, counter-clockwise, ascending.
std::vector<HalfEdge> half_edges(const Mesh &mesh) {
    std::vector<HalfEdge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (const auto &[a, b, c] : mesh.triangles) edges.insert(edges.end(), {{a, b}, {b, c}, {c, a}});
    std::sort(edges.begin(), edges.end());
    return edges;
}

} // namespace

std::vector<OutlineLink> outline(const Mesh &mesh) {
    // A link is inner if both its half-edges lie in triangles.
    const std::vector<HalfEdge> edges = half_edges(mesh);
    const auto has = [&](int from, int to) {
        return std::binary_search(edges.begin(), edges.end(), HalfEdge{from, to});
    };
    std::vector<OutlineLink> links;
    for (const auto &[a, b] : mesh.links) {
        const bool forward = has(a, b), backward = has(b, a);
        if (forward && backward) continue;
        links.push_back(backward ? OutlineLink{b, a, true} : OutlineLink{a, b, forward});
    }
    return links;
}

Neighbours::Neighbours(std::span<const Link> links, int count)
    : first_(static_cast<std::size_t>(count) + 1), lists_(2 * links.size()) {
    for (const auto &[a, b] : links) ++first_[a], ++first_[b];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());

    // Each list is filled from its end, so the links are taken from the last to the first.
    for (auto link = links.rbegin(); link != links.rend(); ++link)
        lists_[--first_[link->b]] = link->a, lists_[--first_[link->a]] = link->b;
}

} // namespace planula
