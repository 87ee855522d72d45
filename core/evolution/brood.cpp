// SPDX-License-Identifier: MIT
#include "evolution/brood.h"

#include "base/check.h"
#include "genome/genome_state.h"

#include <numeric>
#include <utility>

namespace planula {

namespace {

bool same_shape(const Genome &a, const Genome &b) { return a.inputs == b.inputs && a.outputs == b.outputs; }

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

void Elites::add(const Genome &genome, const Evaluation &evaluation) {
    genomes.push_back(genome);
    evaluations.push_back(evaluation.valid() ? evaluation : Evaluation());
}

void save(const Elites &elites, const Innovations &innovations, StateWriter &writer) {
    writer.group("elites");
    save(elites.genomes, innovations, writer);
    for (const Evaluation &evaluation : elites.evaluations) save(evaluation, writer);
}

Elites load_elites(const Population &population, StateReader &reader) {
    const Genome &like = population.genomes.front();
    Elites elites;
    reader.group("elites");
    elites.genomes = load_genomes(like.inputs, like.outputs, population.innovations, reader);
    for (std::size_t left = elites.genomes.size(); left > 0; --left)
        elites.evaluations.push_back(load_evaluation(reader));
    return elites;
}

Population brood(const Population &population, const Parents &parents, const ParentDraw &draw, bool recurrent,
                 const NeatParameters &parameters, std::uint64_t seed) {
    CHECK(!parents.genomes.empty() && parents.species.empty());
    for (const Genome &parent : parents.genomes)
        CHECK(same_shape(parent, population.genomes.front()), parent.id);
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
