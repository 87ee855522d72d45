// SPDX-License-Identifier: MIT
// A polygon as triangles, for shapes that must be convex.
#pragma once

#include "base/vec2.h"

#include <array>
#include <vector>

namespace planula {

/// Triangles that fill a polygon that does not cross itself, one for each point but two (by cutting off ears).
std::vector<std::array<Vec2d, 3>> triangulate(std::vector<Vec2d> polygon);

} // namespace planula
