// SPDX-License-Identifier: MIT
#include "physics/ground.h"

#include "body/body.h"
#include "physics/laws/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planula {

namespace {

/// A plane counts from its point nearest to the origin, where the numbers of nodes are finest.
template <class T> Piece<T> piece_between(Vec2<T> from, Vec2<T> to) {
    const Vec2d a{from.x, from.y}, b{to.x, to.y}, along = b - a;
    return {from,
            to,
            {rounded_to<T>(foot_on_segment({}, a, b).point),
             rounded_to<T>(-right_normal(along) / length(along))}};
}

bool is_level(const std::vector<Vec2d> &line) {
    return std::all_of(line.begin(), line.end(), [&](Vec2d point) { return point.y == line.front().y; });
}

} // namespace

Vec2d origin_for(std::span<const Vec2d> positions, const Environment &environment) {
    const Vec2d centre = centre_of_mass(positions);
    const double x = std::round(centre.x);
    return {x, environment.has_ground ? ground_height(environment, x) : std::round(centre.y)};
}

template <class T> std::vector<Piece<T>> lay_ground(const Environment &environment, Vec2d origin) {
    if (!environment.has_ground) return {};
    constexpr T far = std::numeric_limits<T>::infinity();
    const auto level = [](T left, T right, Vec2<T> point) -> Piece<T> {
        return {{left, point.y}, {right, point.y}, {point, {0, 1}}};
    };
    const auto &line = environment.ground;
    if (is_level(line))
        return {level(-far, far, rounded_to<T>(line.empty() ? -origin : line.front() - origin))};

    // Different points may become equal by rounding.
    Vec2<T> last = rounded_to<T>(line.front() - origin);
    std::vector<Piece<T>> pieces{level(-far, last.x, last)};
    for (const Vec2d point : line) {
        const Vec2<T> next = rounded_to<T>(point - origin);
        if (next != last) pieces.push_back(piece_between(last, next));
        last = next;
    }
    pieces.push_back(level(last.x, far, last));
    return pieces;
}

template std::vector<Piece<float>> lay_ground(const Environment &, Vec2d);
template std::vector<Piece<double>> lay_ground(const Environment &, Vec2d);

} // namespace planula
