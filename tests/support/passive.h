// SPDX-License-Identifier: MIT
// Bodies without actuation, grown from random genomes and set on the ground: do they come to rest?
#pragma once

#include "development/grow.h"
#include "locomotion/trial.h"
#include "network/network.h"
#include "physics/embody.h"
#include "support/specimens.h"

#include <optional>

namespace planula::specimens {

/// How long a body keeps moving, in steps; `limit` if it is still moving then.
struct Rest {
    int steps;
    bool moving;
};

/// The body of random genome `number`, dropped on the ground of the paper; nothing if it does not grow one.
inline std::optional<Rest> drop(Actuation actuation, std::uint64_t number, int limit) {
    Parameters p;
    const Network network = express(random_genome(actuation, number), p.network.propagation_limit);
    const Growth growth = grow(network, actuation, p);
    if (growth.outcome != Outcome::viable) return std::nullopt;
    p.settling.settle_limit = limit;
    p.gait.locomotion_steps = 0;
    const SoftBodyModel model = soft_body(growth.body, land(), p);
    const auto gait = make_gait(actuation, network, growth.body, growth.tissue, p);
    const auto engine = make_engine("native");
    const Trial trial = locomote(model, land(), 0, p, *gait, *engine);
    return Rest{trial.settle_steps, trial.outcome != Outcome::viable};
}

} // namespace planula::specimens
