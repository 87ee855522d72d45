// SPDX-License-Identifier: MIT
// An upright rectangle, any side of which may be infinitely far.
#pragma once

#include "base/vec2.h"

#include <limits>

namespace planula {

struct Box {
    double left = -std::numeric_limits<double>::infinity(), right = std::numeric_limits<double>::infinity();
    double bottom = -std::numeric_limits<double>::infinity(), top = std::numeric_limits<double>::infinity();

    /// The left and the bottom side belong to it, the others do not.
    bool holds(Vec2d point) const {
        return left <= point.x && point.x < right && bottom <= point.y && point.y < top;
    }
    friend bool operator==(const Box &, const Box &) = default;
};

} // namespace planula
