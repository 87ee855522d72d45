// SPDX-License-Identifier: MIT
#include "body/damage.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "geometry/components.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace planula {

namespace {

/// How early a cell is lost: the lowest first.
double rank_of(std::size_t cell, Vec2d from_centre, Side side) {
    switch (side) {
    case Side::left:
        return from_centre.x;
    case Side::right:
        return -from_centre.x;
    case Side::bottom:
        return from_centre.y;
    case Side::top:
        return -from_centre.y;
    case Side::middle:
        return squared_length(from_centre);
    case Side::edge:
        return -squared_length(from_centre);
    case Side::random:
        return static_cast<double>(mix(cell + 1) >> 11);
    }
    return 0;
}

/// A mark for each cell that is lost.
std::vector<char> lost_cells(const Body &body, const Damage &damage) {
    const Vec2d centre = centre_of_mass(body.positions);
    std::vector<char> lost(body.positions.size());
    if (damage.within) {
        for (std::size_t i = 0; i < lost.size(); ++i)
            lost[i] = damage.within->holds(body.positions[i] - centre);
        return lost;
    }
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < lost.size(); ++i)
        order.push_back({rank_of(i, body.positions[i] - centre, damage.side), i});
    std::sort(order.begin(), order.end());
    const auto count = static_cast<std::size_t>(damage.share * static_cast<double>(lost.size()) + 0.5);
    for (std::size_t i = 0; i < count; ++i) lost[order[i].second] = 1;
    return lost;
}

} // namespace

void check_damage(const Damage &damage) {
    const auto require = [](bool holds, const std::string &rule, double value) {
        if (!holds) throw InputError("damage: " + rule + ", not " + to_text(value));
    };
    require(damage.at >= 0, "at is a step of locomotion, 0 or more", damage.at);
    require(damage.share >= 0 && damage.share <= 1, "share is a share of the cells, 0 to 1", damage.share);
    if (!damage.within) return;
    require(damage.within->left < damage.within->right, "within.from must be less than within.to",
            damage.within->left);
    require(damage.within->bottom < damage.within->top, "within.bottom must be less than within.top",
            damage.within->bottom);
}

std::vector<int> cells_left(const Body &body, const Damage &damage) {
    const std::vector<char> lost = lost_cells(body, damage);
    Components parts(body.cells());
    for (const auto &[a, b] : body.mesh.links)
        if (!lost[a] && !lost[b]) parts.join(a, b);
    std::vector<int> largest;
    std::vector<char> seen = lost;
    for (int first = 0; first < body.cells(); ++first) {
        std::vector<int> part;
        for (int cell = first; cell < body.cells() && !seen[first]; ++cell)
            if (!lost[cell] && parts.connected(first, cell)) part.push_back(cell);
        for (const int cell : part) seen[cell] = 1;
        if (part.size() > largest.size()) largest = std::move(part);
    }
    return largest;
}

Body part_of(const Body &body, std::span<const int> cells) {
    Body part;
    std::vector<int> number(body.positions.size(), -1); // of a cell in the part
    for (const int cell : cells) {
        number[cell] = part.cells();
        part.positions.push_back(body.positions[cell]);
    }
    for (std::size_t i = 0; i < body.mesh.links.size(); ++i) {
        const int a = number[body.mesh.links[i].a], b = number[body.mesh.links[i].b];
        if (a < 0 || b < 0) continue;
        part.mesh.links.push_back({a, b});
        part.rest_lengths.push_back(body.rest_lengths[i]);
    }
    for (std::size_t i = 0; i < body.mesh.triangles.size(); ++i) {
        const auto &[first, second, third] = body.mesh.triangles[i];
        const int a = number[first], b = number[second], c = number[third];
        if (a < 0 || b < 0 || c < 0) continue;
        part.mesh.triangles.push_back({a, b, c});
        part.areas.push_back(body.areas[i]);
    }
    part.outline = outline(part.mesh);
    return part;
}

} // namespace planula
