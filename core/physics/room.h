// SPDX-License-Identifier: MIT
// Whether a body fits where it is to start (decision 0024).
#pragma once

#include "physics/environment.h"
#include "physics/soft_body.h"

#include <span>

namespace planula {

/// Whether, with its nodes at these positions, nothing of the soft body lies in or at a wall, no obstacle crosses it,
/// and it is apart from the loose object. Always true without walls and object.
bool has_room(const SoftBodyModel &model, std::span<const Vec2d> positions, const Environment &environment);

/// Whether a point is inside a polygon.
bool is_inside(Vec2d point, std::span<const Vec2d> polygon);

} // namespace planula
