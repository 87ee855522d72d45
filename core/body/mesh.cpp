// SPDX-License-Identifier: MIT
#include "body/mesh.h"

#include "base/counting_sort.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace planula {

std::vector<OutlineLink> outline(const Mesh &mesh) {
    // Each side of a triangle as the link it lies on, and whether it goes down from the higher end.
    std::vector<std::array<int, 3>> sides;
    sides.reserve(3 * mesh.triangles.size());
    int highest = 1;
    const auto add = [&](int from, int to) {
        sides.push_back({std::min(from, to), std::max(from, to), from > to});
        highest = std::max(highest, sides.back()[1]);
    };
    for (const auto &[a, b, c] : mesh.triangles) add(a, b), add(b, c), add(c, a);
    counting_sort(sides, highest + 1);

    // Both are in ascending order.
    std::vector<OutlineLink> links;
    auto side = sides.begin();
    for (const auto &[a, b] : mesh.links) {
        bool up = false, down = false;
        for (; side != sides.end() && (*side)[0] == a && (*side)[1] == b; ++side)
            ((*side)[2] ? down : up) = true;
        if (up && down) continue; // inside
        links.push_back(down ? OutlineLink{b, a, true} : OutlineLink{a, b, up});
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
