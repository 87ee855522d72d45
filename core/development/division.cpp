// SPDX-License-Identifier: MIT
#include "development/division.h"

#include "base/hash.h"
#include "base/math.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// A sum of unit vectors shorter than this is rounding error: they cancel.
constexpr double cancelled = 1e-12;

Vec2d turned(Vec2d direction, double angle) {
    const double c = math::cos(angle), s = math::sin(angle);
    return {direction.x * c - direction.y * s, direction.x * s + direction.y * c};
}

/// A number in [-1, 1) from 32 bits.
double symmetric(std::uint64_t bits) { return static_cast<double>(bits & 0xffffffff) * 0x1p-31 - 1; }

} // namespace

Vec2d division_direction(const Embryo &embryo, int cell, double angle_output) {
    Vec2d mean;
    for (const int neighbour : embryo.neighbours[cell]) mean += embryo.cells[neighbour].orientation;
    const double norm = length(mean);
    const Vec2d base = norm > cancelled ? mean / norm : embryo.cells[cell].orientation;
    const Vec2d direction = turned(base, math::pi * angle_output);
    return direction / length(direction);
}

void remove_cells(std::span<const char> dying, Embryo &embryo) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < embryo.cells.size(); ++i) {
        if (dying[i]) continue;
        if (kept != i) embryo.cells[kept] = embryo.cells[i];
        ++kept;
    }
    embryo.cells.resize(kept);
    embryo.activations.remove(dying);
}

Vec2d daughter_position(Vec2d mother, Vec2d direction, int daughter_id, const Parameters &p) {
    const std::uint64_t bits = mix(static_cast<std::uint64_t>(daughter_id));
    const double reach = p.division_jitter / std::sqrt(2.0);
    const Vec2d offset{symmetric(bits) * reach, symmetric(bits >> 32) * reach};
    return mother + direction * (2 * p.cell_radius) + offset;
}

bool divide(int mother, Vec2d direction, const Parameters &p, Embryo &embryo) {
    const Vec2d place = daughter_position(embryo.cells[mother].position, direction, embryo.births, p);
    const double surely_clear =
        1.001 * p.division_clearance * p.division_clearance; // most are, and no root is needed
    for (int i = 0; i < static_cast<int>(embryo.cells.size()); ++i) {
        const Vec2d offset = embryo.cells[i].position - place;
        if (squared_length(offset) > surely_clear) continue;
        if (i != mother && length(offset) < p.division_clearance) return false;
    }

    embryo.cells[mother].orientation = direction;
    Cell daughter = embryo.cells[mother];
    daughter.id = embryo.births++;
    daughter.position = place;
    embryo.cells.push_back(daughter);
    embryo.activations.append_copy(mother);
    embryo.largest = std::max(embryo.largest, static_cast<int>(embryo.cells.size()));
    return true;
}

} // namespace planula
