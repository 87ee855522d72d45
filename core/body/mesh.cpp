// SPDX-License-Identifier: MIT
#include "body/mesh.h"

#include <algorithm>
#include <numeric>
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

Neighbours::Neighbours(const Mesh &mesh, int count)
    : first_(static_cast<std::size_t>(count) + 1), lists_(2 * mesh.links.size()) {
    for (const auto &[a, b] : mesh.links) ++first_[a], ++first_[b];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());

    // Each list is filled from its end, so the links are taken from the last to the first.
    for (auto link = mesh.links.rbegin(); link != mesh.links.rend(); ++link)
        lists_[--first_[link->b]] = link->a, lists_[--first_[link->a]] = link->b;
}

} // namespace planula
