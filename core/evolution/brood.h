// SPDX-License-Identifier: MIT
// How a search that keeps individuals makes a generation of them: children by NEAT's crossover and mutation
// (evolution/breed.h), without species and without unchanged copies, since those who are kept need not live
// again. All children are one species, the first of the run, so that tables keep their meaning.
#pragma once

#include "evolution/breed.h"
#include "evolution/evaluation.h"

namespace planula {

/// One that has lived and is kept.
struct Kept {
    Genome genome;
    Evaluation evaluation;
};

void save(const Kept &kept, StateWriter &writer);
/// Throws InputError unless a sound genome and its evaluation come next.
Kept load_kept(StateReader &reader);

/// The generation after `population`: parameters.population children of `parents`, each parent drawn by
/// `draw`. Parents::species is empty; there is at least one parent.
Population brood(const Population &population, const Parents &parents, const ParentDraw &draw, bool recurrent,
                 const Parameters &parameters, std::uint64_t seed);

} // namespace planula
