// SPDX-License-Identifier: MIT
// How a search that keeps individuals makes a generation of them: children by NEAT's crossover and mutation
// (evolution/breed.h), without species and without unchanged copies, since individuals that are kept need not be
// simulated again. All children are one species, the first of the run, so that tables keep their meaning.
#pragma once

#include "evolution/breed.h"
#include "evolution/evaluation.h"

namespace planula {

/// Evaluated individuals that are kept.
struct Elites {
    std::vector<Genome> genomes;
    std::vector<Evaluation> evaluations;

    std::size_t size() const { return genomes.size(); }
    /// Of an invalid individual the evaluation is not kept.
    void add(const Genome &genome, const Evaluation &evaluation);
};

/// The innovations are those of the run.
void save(const Elites &elites, const Innovations &innovations, StateWriter &writer);
/// Throws InputError unless sound genomes, of the population's shape and made of its innovations, and evaluations come
/// next.
Elites load_elites(const Population &population, StateReader &reader);

/// The generation after `population`: parameters.population children of `parents`, each parent drawn by `draw`. There
/// is at least one parent, all have the shape of the population's genomes, and Parents::species is empty.
Population brood(const Population &population, const Parents &parents, const ParentDraw &draw, bool recurrent,
                 const NeatParameters &parameters, std::uint64_t seed);

} // namespace planula
