// SPDX-License-Identifier: MIT
// Damage to a developed body: which cells it loses, and what is left (decision 0025). Cells are chosen by where they lay
// at the end of development, so that the same body always loses the same cells, however it lies and moves then.
#pragma once

#include "base/box.h"
#include "body/body.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace planula {

/// Where the cells are lost first: towards a side, nearest to the centre of mass, farthest from it, or anywhere.
enum class Side { left, right, bottom, top, middle, edge, random };
inline constexpr std::array<std::string_view, 7> side_names{"left",   "right", "bottom", "top",
                                                            "middle", "edge",  "random"};

struct Damage {
    int at = 0;       // step of locomotion; 0: after growth, before the body is in its world
    double share = 0; // of the cells, rounded to the nearest whole number: those that come first by `side`
    Side side = Side::left;    // equals are ordered by their numbers
    std::optional<Box> within; // instead of both: all cells in it, seen from the centre of mass
};

/// Throws InputError with the rule and the value: a share outside 0 … 1, an empty box, a step below 0.
void check_damage(const Damage &damage);

/// The cells that are left, ascending: of those that are not lost the largest part that links hold together, of equal
/// ones that with the lowest cell. What falls off is lost too.
std::vector<int> cells_left(const Body &body, const Damage &damage);

/// The part of a body that these cells, ascending, make, with the links and triangles that they have among themselves.
Body part_of(const Body &body, std::span<const int> cells);

} // namespace planula
