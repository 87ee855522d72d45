// SPDX-License-Identifier: MIT
// The ground of an environment as the laws of contact read it (laws/ground.h): a plane, or the pieces of a polyline
// (§2.5; decision 0010).
#pragma once

#include "physics/environment.h"
#include "physics/laws/ground.h"

#include <span>
#include <vector>

namespace planula {

template <class T> Vec2<T> rounded_to(Vec2d v) { return {static_cast<T>(v.x), static_cast<T>(v.y)}; }

/// The point that nodes and ground are counted from: near the body, and on the ground if there is one. Numbers are
/// finest there. It lies whole cells to the side, so that rounding of the centre of mass changes no result.
Vec2d origin_for(std::span<const Vec2d> positions, const Environment &environment);

/// The pieces of an environment's ground, counted from `origin`, from left to right: each begins where the one before
/// ends, and may be upright. Without ground there are no pieces; ground that is level everywhere is one piece. T: float
/// or double.
template <class T> std::vector<Piece<T>> lay_ground(const Environment &environment, Vec2d origin);

} // namespace planula
