// SPDX-License-Identifier: MIT
#include "physics/environment.h"

#include "physics/laws/contact.h"
#include "physics/rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace planula {

namespace {

/// A polyline of finite points, from left to right.
void check_line(const std::vector<Vec2d> &line, const std::string &name) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        require_place(line[i], name);
        require(i == 0 || line[i - 1].x < line[i].x, name + " points must ascend in x", line[i].x);
    }
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

    require(environment.ground.size() != 1, "a polyline ground needs two points or more", 1);
    check_line(environment.ground, "ground");
    check_obstacles(environment);
}

double height_of(const std::vector<Vec2d> &line, double x) {
    if (line.empty()) return 0;
    if (x <= line.front().x) return line.front().y;
    if (x >= line.back().x) return line.back().y;
    const auto right = std::upper_bound(line.begin(), line.end(), x,
                                        [](double value, Vec2d point) { return value < point.x; });
    const Vec2d a = *(right - 1), b = *right;
    return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x));
}

double ground_height(const Environment &environment, double x) { return height_of(environment.ground, x); }

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
