// SPDX-License-Identifier: MIT
// What happens to a body on its way beside that it moves: it comes into other worlds, and it loses cells (decision
// 0025). Steps are those of locomotion, multiples of the knot interval.
#pragma once

#include "physics/environment.h"
#include "physics/soft_body.h"

#include <span>
#include <vector>

namespace planula {

/// Another world that the body comes into, as it is and moves.
struct Phase {
    int at = 0; // the step that it begins with
    Environment environment;
    double actuation_range = 0;
    bool settles = false; // first comes to rest, with its muscles held as they are
};

/// What a body did in one of several worlds.
struct PhaseResult {
    int steps = 0;        // of locomotion
    int settle_steps = 0; // until it was at rest; 0 if it did not settle
    Vec2d start, finish;  // centre of mass before and after these steps
    friend bool operator==(const PhaseResult &, const PhaseResult &) = default;
};

/// The cells that a body loses, and what is left.
struct Loss {
    int at = 0;            // the step before which it happens
    std::vector<int> kept; // nodes, ascending
    SoftBodyModel model;   // of these
};

struct Course {
    std::span<const Phase> phases{}; // ascending
    const Loss *loss = nullptr;
    int refinement = 1; // physics steps for each step of phases, loss and currents
};

} // namespace planula
