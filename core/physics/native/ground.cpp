// SPDX-License-Identifier: MIT
#include "physics/native/ground.h"

#include "physics/laws/contact.h"

#include <algorithm>
#include <limits>

namespace planula::native {

namespace {

Vec2f to_float(Vec2d v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }
Vec2d to_double(Vec2f v) { return {v.x, v.y}; }

/// A plane counts from its point nearest to the origin, where the numbers of nodes are finest.
Piece piece_between(Vec2f from, Vec2f to) {
    const Vec2d a = to_double(from), b = to_double(to), along = b - a;
    return {from,
            to,
            {to_float(foot_on_segment({}, a, b).point), to_float(-right_normal(along) / length(along))}};
}

bool is_level(const std::vector<Vec2d> &line) {
    return std::all_of(line.begin(), line.end(), [&](Vec2d point) { return point.y == line.front().y; });
}

} // namespace

std::vector<Piece> lay_ground(const Environment &environment, Vec2d origin) {
    if (!environment.has_ground) return {};
    constexpr float far = std::numeric_limits<float>::infinity();
    const auto level = [](float left, float right, Vec2f point) -> Piece {
        return {{left, point.y}, {right, point.y}, {point, {0, 1}}};
    };
    const auto &line = environment.ground;
    if (is_level(line)) return {level(-far, far, to_float(line.empty() ? -origin : line.front() - origin))};

    // Points may fall together in float.
    Vec2f last = to_float(line.front() - origin);
    std::vector<Piece> pieces{level(-far, last.x, last)};
    for (const Vec2d point : line) {
        const Vec2f next = to_float(point - origin);
        if (next != last) pieces.push_back(piece_between(last, next));
        last = next;
    }
    pieces.push_back(level(last.x, far, last));
    return pieces;
}

} // namespace planula::native
