// SPDX-License-Identifier: MIT
// Points for tests of geometry.
#pragma once

#include "base/random.h"
#include "base/vec2.h"

#include <vector>

namespace planula::test {

/// So many in a square of side 10.
inline std::vector<Vec2d> scatter(int count, std::uint64_t seed) {
    Stream stream(seed, 0, 0, Purpose::sampling);
    std::vector<Vec2d> points(static_cast<std::size_t>(count));
    for (auto &point : points) point.x = stream.uniform() * 10, point.y = stream.uniform() * 10;
    return points;
}

} // namespace planula::test
