// SPDX-License-Identifier: MIT
// Genomes in saved state (base/state.h). They read back to the bit; what breaks a rule of check_genome is
// refused.
#pragma once

#include "base/state.h"
#include "genome/genome.h"

namespace planula {

void save(const Genome &genome, StateWriter &writer);

/// Throws InputError unless a whole, sound genome comes next.
Genome load_genome(StateReader &reader);

} // namespace planula
