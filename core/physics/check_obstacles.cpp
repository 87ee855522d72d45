// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/text.h"
#include "physics/laws/contact.h"
#include "physics/room.h"
#include "physics/rules.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace planula {

void require(bool holds, const std::string &rule, double value) {
    if (!holds) throw InputError("environment: " + rule + ", not " + to_text(value));
}

void require_amount(const std::string &name, double value) {
    require(std::isfinite(value) && value >= 0, name + " must be a finite number, 0 or more", value);
}

void require_place(Vec2d point, const std::string &name) {
    constexpr double farthest = 1e9;
    for (const double coordinate : {point.x, point.y}) {
        require(std::isfinite(coordinate), name + " points must be finite", coordinate);
        require(std::abs(coordinate) <= farthest,
                name + " points must lie within " + to_text(farthest) + " of 0", coordinate);
    }
}

namespace {

constexpr std::size_t most_points = 10000; // of all obstacles

struct Side {
    Vec2d a, b;
    double left() const { return std::min(a.x, b.x); }
    double right() const { return std::max(a.x, b.x); }
};

double distance_from(Vec2d point, Side side) {
    return length(point - foot_on_segment(point, side.a, side.b).point);
}

bool touch(Side one, Side other) {
    const auto turn = [](Vec2d a, Vec2d b, Vec2d c) { return cross(b - a, c - a); };
    const auto parts = [&](Side by, Side of) {
        return (turn(by.a, by.b, of.a) > 0) != (turn(by.a, by.b, of.b) > 0);
    };
    if (parts(one, other) && parts(other, one)) return true;
    return distance_from(one.a, other) == 0 || distance_from(one.b, other) == 0 ||
           distance_from(other.a, one) == 0 || distance_from(other.b, one) == 0;
}

std::vector<Side> sides_of(const std::vector<Vec2d> &points) {
    std::vector<Side> sides;
    for (std::size_t i = 0; i < points.size(); ++i)
        sides.push_back({points[i], points[(i + 1) % points.size()]});
    return sides;
}

/// No side touches another, but its neighbours at their common point.
void check_simple(const std::vector<Vec2d> &points, const std::string &name) {
    const std::vector<Side> sides = sides_of(points);
    const std::size_t count = sides.size();
    std::vector<std::size_t> by_left(count);
    std::iota(by_left.begin(), by_left.end(), std::size_t{0});
    std::sort(by_left.begin(), by_left.end(),
              [&](std::size_t i, std::size_t j) { return sides[i].left() < sides[j].left(); });
    const auto refuse = [&](std::size_t i, std::size_t j) {
        throw InputError("environment: " + name + " must not cross or touch itself: its sides " +
                         to_text(static_cast<std::int64_t>(std::min(i, j) + 1)) + " and " +
                         to_text(static_cast<std::int64_t>(std::max(i, j) + 1)) + " do");
    };
    for (std::size_t k = 0; k < count; ++k)
        for (std::size_t l = k + 1; l < count && sides[by_left[l]].left() <= sides[by_left[k]].right(); ++l) {
            const std::size_t i = by_left[k], j = by_left[l];
            if ((i + 1) % count == j || (j + 1) % count == i) {
                const auto [first, second] = (i + 1) % count == j ? std::pair(i, j) : std::pair(j, i);
                if (distance_from(sides[second].b, sides[first]) == 0 ||
                    distance_from(sides[first].a, sides[second]) == 0)
                    refuse(i, j);
            } else if (touch(sides[i], sides[j])) {
                refuse(i, j);
            }
        }
}

/// Where a body's lowest cell is at the start, and a cell above it.
Vec2d start_of(const Environment &environment) {
    return environment.has_ground ? Vec2d{0, ground_height(environment, 0) + 0.5} : Vec2d{};
}

void check_obstacle(const Obstacle &obstacle, const std::string &name, Vec2d start) {
    const auto &points = obstacle.points;
    require(points.size() >= 3, name + " needs three points or more", static_cast<double>(points.size()));
    if (obstacle.friction) require_amount("the friction of " + name, *obstacle.friction);
    double extent = 0;
    for (const Vec2d point : points) {
        require_place(point, name);
        extent = std::max(extent, length(point - points.front()));
    }
    require(extent >= 1, name + " must be a cell long or more, or it could lie between the cells of a body",
            extent);
    check_simple(points, name);
    double nearest = is_inside(start, points) ? 0 : 1;
    for (const Side side : sides_of(points)) nearest = std::min(nearest, distance_from(start, side));
    require(nearest >= 0.5,
            name + " must leave the place free where bodies start: its distance from (" + to_text(start.x) +
                ", " + to_text(start.y) + ") must be half a cell or more",
            nearest);
}

void check_ceiling(const Environment &environment) {
    const auto &ceiling = environment.ceiling;
    require(ceiling.size() != 1, "a ceiling needs two points or more", 1);
    if (ceiling.empty()) return;
    for (std::size_t i = 0; i < ceiling.size(); ++i) {
        require_place(ceiling[i], "ceiling");
        require(i == 0 || ceiling[i - 1].x < ceiling[i].x, "ceiling points must ascend in x", ceiling[i].x);
    }
    std::vector<double> places{0};
    for (const Vec2d point : ceiling) places.push_back(point.x);
    if (environment.has_ground)
        for (const Vec2d point : environment.ground) places.push_back(point.x);
    for (const double x : places) {
        if (!environment.has_ground && x != 0) continue;
        const double room =
            height_of(ceiling, x) - (environment.has_ground ? ground_height(environment, x) : 0);
        require(room >= 1,
                std::string("the ceiling must be a cell or more above the ") +
                    (environment.has_ground ? "ground" : "place where bodies start") +
                    "; at x = " + to_text(x) + " it is",
                room);
    }
}

void check_patches(const Environment &environment) {
    const auto &patches = environment.friction_patches;
    if (patches.empty()) return;
    require(environment.has_ground || !environment.ceiling.empty(),
            "friction patches are of ground and ceiling: there must be one of them; patches",
            static_cast<double>(patches.size()));
    for (std::size_t i = 0; i < patches.size(); ++i) {
        const auto &[from, to, friction] = patches[i];
        require_place({from, to}, "friction patch");
        require(from < to, "a friction patch must have from < to; from " + to_text(from) + " to", to);
        require_amount("the friction of a patch", friction);
        require(i == 0 || patches[i - 1].to <= from,
                "friction patches must ascend and not overlap: each begins where the one before ends (" +
                    to_text(i == 0 ? 0 : patches[i - 1].to) + ") or to the right of it",
                from);
    }
}

void check_object(const Environment &environment) {
    constexpr double least = 0.1;
    for (const Vec2d cell : environment.object.positions) {
        require_place(cell, "object");
        const std::string where =
            " of the object at (" + to_text(cell.x) + ", " + to_text(cell.y) + ") must be ";
        double room = 1;
        if (environment.has_ground) room = cell.y - ground_height(environment, cell.x);
        require(room >= least, "the cell" + where + "above the ground by 0.1 or more", room);
        if (!environment.ceiling.empty()) room = height_of(environment.ceiling, cell.x) - cell.y;
        require(room >= least, "the cell" + where + "below the ceiling by 0.1 or more", room);
        for (const Obstacle &obstacle : environment.obstacles) {
            room = is_inside(cell, obstacle.points) ? 0 : 1;
            for (const Side side : sides_of(obstacle.points))
                room = std::min(room, distance_from(cell, side));
            require(room >= least, "the cell" + where + "0.1 or more from all obstacles", room);
        }
        require(length(cell - start_of(environment)) >= 1,
                "the cell" + where + "a cell or more from where bodies start",
                length(cell - start_of(environment)));
    }
}

} // namespace

void check_obstacles(const Environment &environment) {
    std::size_t points = 0;
    for (std::size_t i = 0; i < environment.obstacles.size(); ++i) {
        points += environment.obstacles[i].points.size();
        require(points <= most_points, "obstacles may have 10000 points in all", static_cast<double>(points));
        check_obstacle(environment.obstacles[i], "obstacle " + to_text(static_cast<std::int64_t>(i + 1)),
                       start_of(environment));
    }
    check_ceiling(environment);
    check_patches(environment);
    check_object(environment);
}

} // namespace planula
