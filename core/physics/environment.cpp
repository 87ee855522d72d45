// SPDX-License-Identifier: MIT
#include "physics/environment.h"

#include "base/error.h"
#include "base/text.h"
#include "physics/laws/contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace planula {

namespace {

constexpr double farthest_ground = 1e9; // where doubles are still 1e-7 cells apart

void require(bool holds, const std::string &rule, double value) {
    if (!holds) throw InputError("environment: " + rule + ", not " + to_text(value));
}

void require_amount(const char *name, double value) {
    require(std::isfinite(value) && value >= 0, std::string(name) + " must be a finite number, 0 or more",
            value);
}

} // namespace

void check_environment(const Environment &environment) {
    require_amount("gravity", environment.gravity);
    require_amount("friction", environment.friction);
    require_amount("normal drag", environment.drag_normal);
    require_amount("tangential drag", environment.drag_tangential);
    require(std::isfinite(environment.flow.x), "flow must be finite", environment.flow.x);
    require(std::isfinite(environment.flow.y), "flow must be finite", environment.flow.y);
    require(environment.gravity == 0 || environment.has_ground,
            "gravity without ground lets a body fall for ever: give a ground, or gravity 0",
            environment.gravity);
    check_fields(environment);

    // A polyline of finite points, from left to right.
    const auto &ground = environment.ground;
    require(ground.size() != 1, "a polyline ground needs two points or more", 1);
    for (std::size_t i = 0; i < ground.size(); ++i) {
        for (const double coordinate : {ground[i].x, ground[i].y}) {
            require(std::isfinite(coordinate), "ground points must be finite", coordinate);
            require(std::abs(coordinate) <= farthest_ground,
                    "ground points must lie within " + to_text(farthest_ground) + " of 0", coordinate);
        }
        require(i == 0 || ground[i - 1].x < ground[i].x, "ground points must ascend in x", ground[i].x);
    }
}

double ground_height(const Environment &environment, double x) {
    const auto &ground = environment.ground;
    if (ground.empty()) return 0;
    if (x <= ground.front().x) return ground.front().y;
    if (x >= ground.back().x) return ground.back().y;
    const auto right = std::upper_bound(ground.begin(), ground.end(), x,
                                        [](double value, Vec2d point) { return value < point.x; });
    const Vec2d a = *(right - 1), b = *right;
    return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
}

bool is_at_ground(const Environment &environment, Vec2d point, double reach) {
    if (!environment.has_ground) return false;
    if (point.y - ground_height(environment, point.x) < reach) return true;
    // Beside a slope or a wall: the pieces within reach to the left and to the right.
    const auto &ground = environment.ground;
    auto right = std::lower_bound(ground.begin(), ground.end(), point.x - reach,
                                  [](Vec2d each, double value) { return each.x < value; });
    if (right == ground.begin() && right != ground.end()) ++right;
    for (; right != ground.end() && (right - 1)->x <= point.x + reach; ++right)
        if (length(point - foot_on_segment(point, *(right - 1), *right).point) < reach) return true;
    return false;
}

double height_of_lowest(std::span<const Vec2d> points, double aside, const Environment &environment) {
    double lowest = std::numeric_limits<double>::infinity();
    for (const Vec2d p : points) lowest = std::min(lowest, p.y - ground_height(environment, p.x + aside));
    return lowest;
}

} // namespace planula
