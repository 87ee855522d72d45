// SPDX-License-Identifier: MIT
// An individual that grows, settles and moves, with the native engine beside the reference engine.
#pragma once

#include "development/grow.h"
#include "evaluation/conditions.h"
#include "locomotion/trial.h"
#include "network/network.h"
#include "physics/embody.h"
#include "support/lockstep.h"

namespace planula::specimens {

/// Lets a body grow and move in the engine; false if it does not grow one.
inline bool move(const Genome &genome, const Conditions &conditions, Lockstep &lockstep) {
    const Parameters &p = conditions.parameters;
    const Network network = express(genome, p.network.propagation_limit);
    const Growth growth = grow(network, conditions.actuation, p);
    if (growth.outcome != Outcome::viable) return false;
    const SoftBodyModel model = embody(growth.body, conditions.environment, p.body, p.development.time_step);
    const auto gait = make_gait(conditions.actuation, network, growth.body, growth.tissue, p);
    locomote(model, conditions.environment, conditions.actuation_range, p, *gait, lockstep);
    return true;
}

} // namespace planula::specimens
