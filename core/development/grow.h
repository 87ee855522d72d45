// SPDX-License-Identifier: MIT
// Development: from one cell to a body (§2.1–2.4; rules D1 to D20). Every decision_interval steps each cell's
// network decides on death and division; between decisions the cells relax as disks on springs in a viscous
// fluid. Development uses no random numbers and does not depend on the world that the body will move in.
#pragma once

#include "body/body.h"
#include "body/outcome.h"
#include "cell/channels.h"
#include "cell/tissue.h"
#include "development/embryo.h"
#include "network/network.h"
#include "parameters/parameters.h"

#include <functional>

namespace planula {

struct Growth {
    Outcome outcome = Outcome::viable; // viable, died_out, too_small, overgrown or exploded
    int cells = 0;                     // at the end, or when growth stopped
    int largest = 0;
    int births = 0;
    Body body;     // of a viable or too small embryo
    Tissue tissue; // likewise
};

/// Called before the physics of each step, and once with the finished embryo, whose links are the body's, at step
/// development_steps; networks that oscillators are read from have been evaluated there.
using GrowthWatch = std::function<void(int step, const Embryo &embryo)>;

Growth grow(const Network &network, Actuation actuation, const Parameters &parameters,
            const GrowthWatch &watch = {});

} // namespace planula
