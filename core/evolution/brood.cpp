// SPDX-License-Identifier: MIT
#include "evolution/brood.h"

#include "base/check.h"
#include "genome/genome_state.h"

#include <numeric>
#include <utility>

namespace planula {

namespace {

/// All of a generation in the first species of the one before.
Species one_species(const Population &before, const Population &population) {
    Species species;
    species.id = before.species.front().id;
    species.age = before.species.front().age + 1;
    species.representative = population.genomes.front();
    species.members.resize(population.genomes.size());
    std::iota(species.members.begin(), species.members.end(), 0);
    return species;
}

} // namespace

void save(const Kept &kept, StateWriter &writer) {
    save(kept.genome, writer);
    save(kept.evaluation, writer);
}

Kept load_kept(StateReader &reader) {
    Genome genome = load_genome(reader);
    return {std::move(genome), load_evaluation(reader)};
}

Population brood(const Population &population, const Parents &parents, const ParentDraw &draw, bool recurrent,
                 const Parameters &parameters, std::uint64_t seed) {
    CHECK(!parents.genomes.empty() && parents.species.empty());
    Population next;
    next.generation = population.generation + 1;
    next.next_genome = population.next_genome;
    next.next_species = population.next_species;
    next.innovations = population.innovations;
    for (int birth = 0; birth < parameters.population; ++birth) {
        Stream stream(seed, next.generation, static_cast<std::uint32_t>(birth), Purpose::reproduction);
        Genome child = breed(parents, draw, next.genomes, recurrent, parameters, next.innovations, stream);
        child.id = next.next_genome++;
        next.genomes.push_back(std::move(child));
    }
    next.species.push_back(one_species(population, next));
    return next;
}

} // namespace planula
