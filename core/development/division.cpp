// SPDX-License-Identifier: MIT
#include "development/division.h"

#include "base/check.h"
#include "base/hash.h"
#include "base/math.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// A sum of unit vectors shorter than this is rounding error: they cancel.
constexpr double cancelled = 1e-12;

/// Of complex numbers: lengths multiply, angles add.
Vec2d product(Vec2d a, Vec2d b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

Vec2d turned(Vec2d direction, double angle) {
    return product(direction, {math::cos(angle), math::sin(angle)});
}

/// A number in [-1, 1) from 32 bits.
double symmetric(std::uint64_t bits) { return static_cast<double>(bits & 0xffffffff) * 0x1p-31 - 1; }

} // namespace

void carry_orientations(std::span<const Vec2d> places, Embryo &embryo) {
    CHECK(places.size() == embryo.cells.size(), places.size(), embryo.cells.size());
    // As complex numbers: the angle of Σ conj(before) · after over the links of a cell.
    std::vector<Vec2d> rotations(embryo.cells.size());
    for (const Link &link : embryo.links) {
        const Vec2d from = places[link.b] - places[link.a];
        const Vec2d to = embryo.cells[link.b].position - embryo.cells[link.a].position;
        const Vec2d turn{dot(from, to), cross(from, to)};
        rotations[link.a] += turn;
        rotations[link.b] += turn;
    }
    for (std::size_t i = 0; i < rotations.size(); ++i) {
        if (!(length(rotations[i]) > cancelled)) continue;
        const Vec2d now = product(embryo.cells[i].orientation, rotations[i]);
        embryo.cells[i].orientation = now / length(now);
    }
}

Vec2d division_direction(const Embryo &embryo, int cell, double angle_output,
                         const DevelopmentParameters &p) {
    Vec2d mean;
    for (const int neighbour : embryo.neighbours[cell]) mean += embryo.cells[neighbour].orientation;
    const double norm = length(mean);
    const Vec2d base = norm > cancelled ? mean / norm : embryo.cells[cell].orientation;
    const Vec2d direction = turned(base, math::pi * p.division_angle_range * angle_output);
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

Vec2d daughter_position(Vec2d mother, Vec2d direction, std::uint64_t lineage,
                        const DevelopmentParameters &p) {
    const std::uint64_t bits = mix(lineage);
    const double reach = p.division_jitter / std::sqrt(2.0);
    const Vec2d offset{symmetric(bits) * reach, symmetric(bits >> 32) * reach};
    return mother + direction * (2 * p.cell_radius) + offset;
}

std::uint64_t daughter_lineage(const Cell &mother) {
    return mix(mother.lineage + static_cast<std::uint64_t>(mother.daughters) + 1);
}

bool divide(int mother, Vec2d direction, const DevelopmentParameters &p, Embryo &embryo) {
    const Vec2d place = daughter_position(embryo.cells[mother].position, direction,
                                          daughter_lineage(embryo.cells[mother]), p);
    // Most cells are clearly far enough away, and then no root is needed.
    const double surely_clear = 1.001 * p.division_clearance * p.division_clearance;
    for (int i = 0; i < static_cast<int>(embryo.cells.size()); ++i) {
        const Vec2d offset = embryo.cells[i].position - place;
        if (squared_length(offset) > surely_clear) continue;
        if (i != mother && length(offset) < p.division_clearance) return false;
    }

    Cell daughter = embryo.cells[mother];
    daughter.lineage = daughter_lineage(daughter);
    daughter.id = embryo.births++;
    daughter.daughters = 0;
    daughter.position = place;
    if (p.division_turn != DivisionTurn::nobody) daughter.orientation = direction;
    if (p.division_turn == DivisionTurn::both) embryo.cells[mother].orientation = direction;
    ++embryo.cells[mother].daughters;
    embryo.cells.push_back(daughter);
    embryo.activations.append_copy(mother);
    embryo.largest = std::max(embryo.largest, static_cast<int>(embryo.cells.size()));
    return true;
}

} // namespace planula
