// SPDX-License-Identifier: MIT
// The world that a soft body moves in, as an experiment states it: gravity, ground, friction, fluid drag and flow, in
// any combination (§2.5). The paper's two worlds are rows of experiments/paper/environments.lua.
#pragma once

#include "base/vec2.h"

#include <vector>

namespace planula {

struct Environment {
    double gravity = 0; // downwards, cells/t.u.²
    bool has_ground = false;
    std::vector<Vec2d> ground; // a polyline ascending in x, level beyond its ends; empty: the line y = 0
    double friction = 0;       // Coulomb coefficient between nodes and ground
    double drag_normal = 0;    // λ_N, per length of outline; 0 and 0: no fluid
    double drag_tangential = 0;
    Vec2d flow; // velocity of the fluid, cells/t.u.

    bool has_fluid() const { return drag_normal > 0 || drag_tangential > 0; }
};

/// Throws InputError stating the rule and the value: non-finite or negative numbers, a polyline that does not
/// ascend or leaves ±1e9 cells, gravity without ground (a body would fall for ever).
void check_environment(const Environment &environment);

/// Height of the ground below x; the environment must have ground.
double ground_height(const Environment &environment, double x);

/// Whether a point lies below the ground or less than `reach` from it; never where there is none.
bool is_at_ground(const Environment &environment, Vec2d point, double reach);

} // namespace planula
