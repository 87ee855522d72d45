// SPDX-License-Identifier: MIT
// The world that a soft body moves in, as an experiment states it: gravity, ground, friction, fluid drag and flow, in
// any combination (§2.5), fields that differ from place to place and from time to time (decision 0025), and what else
// there is to touch (decision 0024). The paper's two worlds are rows of experiments/paper/environments.lua.
#pragma once

#include "base/vec2.h"
#include "body/body.h"
#include "physics/fields.h"

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

namespace planula {

/// A closed polygon that does not cross itself, in either direction.
struct Obstacle {
    std::vector<Vec2d> points;
    std::optional<double> friction; // none: the environment's
};

/// Another friction of ground and ceiling between two places along x.
struct FrictionPatch {
    double from = 0, to = 0, friction = 0;
};

struct Environment {
    double gravity = 0; // downwards, cells/t.u.²
    bool has_ground = false;
    std::vector<Vec2d> ground; // a polyline ascending in x, level beyond its ends; empty: the line y = 0
    double friction = 0;       // Coulomb coefficient between nodes and ground
    double drag_normal = 0;    // λ_N, per length of outline; 0 and 0: no fluid
    double drag_tangential = 0;
    Vec2d flow; // velocity of the fluid, cells/t.u.

    double gravity_direction = 0; // counter-clockwise from straight down, degrees
    Current current;              // instead of `flow`, if it changes
    std::vector<Region> regions;  // outside of all of them hold the numbers above

    std::vector<Obstacle> obstacles;
    std::vector<Vec2d> ceiling;                  // a polyline as the ground, above it; empty: none
    std::vector<FrictionPatch> friction_patches; // ascending, apart
    Body object; // a loose object (physics/object.h), world frame; empty: none

    bool has_fluid() const {
        const auto drags = [](const auto &where) {
            return where.drag_normal > 0 || where.drag_tangential > 0;
        };
        return drags(*this) || std::any_of(regions.begin(), regions.end(), drags);
    }
    /// The velocity of the fluid outside of all regions after so many steps of locomotion.
    Vec2d flow_at(double steps) const { return current.changes() ? current.at(steps) : flow; }
    /// Whether there is more to touch than ground of one friction (physics/walls.h).
    bool has_walls() const { return !obstacles.empty() || !ceiling.empty() || !friction_patches.empty(); }
};

/// Throws InputError stating the rule and the value: non-finite or negative numbers, a polyline that does not
/// ascend or leaves ±1e9 cells, gravity without ground (a body would fall for ever); gravity that points up, regions
/// without inside, more than 100 regions, buoyancy in a region with sides or in tilted gravity; and what
/// check_obstacles.cpp says.
void check_environment(const Environment &environment);

/// Height at x of a polyline as the ground is one: level beyond its ends, empty: 0.
double height_of(const std::vector<Vec2d> &line, double x);
/// Height of the ground below x; the environment must have ground.
double ground_height(const Environment &environment, double x);

/// Whether a point lies below the ground or less than `reach` from it; never where there is none.
bool is_at_ground(const Environment &environment, Vec2d point, double reach);

/// How high the lowest of these points, moved along x by `aside`, is above the ground, which the environment must have.
double height_of_lowest(std::span<const Vec2d> points, double aside, const Environment &environment);

} // namespace planula
