// SPDX-License-Identifier: MIT
// A population as saved state (base/state.h), between two generations: complete, not yet evaluated. What is loaded is
// whole: genomes, species and innovations agree with each other and with the shape of the networks, so that breeding
// from it breaks no promise.
#pragma once

#include "base/state.h"
#include "evolution/population.h"

namespace planula {

/// Needs a complete generation (evolution/species.h).
void save(const Population &population, StateWriter &writer);

/// A population of `size` genomes in a run of `generations`. Throws InputError naming the rule that the bytes
/// break.
Population load_population(const NetworkShape &shape, int size, int generations, StateReader &reader);

/// What the genome alone cannot say: throws InputError unless it is born before the population's next genome and, in a
/// network without recurrence, all its links climb.
void check_member(const Genome &genome, const NetworkShape &shape, const Population &population,
                  const StateReader &reader);

} // namespace planula
