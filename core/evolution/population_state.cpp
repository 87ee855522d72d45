// SPDX-License-Identifier: MIT
#include "evolution/population_state.h"

#include "base/check.h"
#include "base/text.h"
#include "genome/genome_state.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <set>

namespace planula {

namespace {

constexpr std::int64_t most_genomes = std::int64_t{1} << 53; // ids that a table's reader keeps exactly
constexpr std::int64_t longest_age = 1'000'000'000;          // of a species, far from overflow

/// A species of a complete generation is the next run of slots, represented by the first of them.
bool is_complete(const Population &population) {
    int slot = 0;
    for (const Species &species : population.species) {
        if (species.members.empty() || !(species.representative == population.genomes.at(slot))) return false;
        for (const int member : species.members)
            if (member != slot++) return false;
    }
    return slot == static_cast<int>(population.genomes.size());
}

void save(const Species &species, StateWriter &writer) {
    writer.integer(species.id).integer(species.age).integer(species.stagnation);
    writer.real(species.best_ever).integer(species.best ? 1 : 0);
    writer.integer(static_cast<std::int64_t>(species.members.size()));
}

double load_score(StateReader &reader) {
    const double score = reader.finite();
    if (score < 0) reader.refuse("a best score is below 0");
    return score;
}

/// The species whose members follow those placed so far.
Species load_species(int placed, const Population &population, StateReader &reader) {
    Species species;
    species.id = static_cast<int>(reader.integer(0, std::int64_t{population.next_species} - 1));
    species.age = static_cast<int>(reader.integer(0, longest_age));
    species.stagnation = static_cast<int>(reader.integer(0, longest_age));
    species.best_ever = load_score(reader);
    species.best = reader.integer(0, 1) == 1;
    const auto free = static_cast<std::int64_t>(population.genomes.size()) - placed;
    species.members.resize(static_cast<std::size_t>(reader.integer(1, std::max<std::int64_t>(free, 1))));
    if (free < 1) reader.refuse("more species than genomes");
    std::iota(species.members.begin(), species.members.end(), placed);
    species.representative = population.genomes[placed];
    return species;
}

void load_all_species(Population &population, StateReader &reader) {
    std::set<int> ids;
    int placed = 0, marked = 0;
    for (std::size_t left = reader.count(); left > 0; --left) {
        Species species = load_species(placed, population, reader);
        if (!ids.insert(species.id).second) reader.refuse("two species have one id");
        marked += species.best;
        placed += static_cast<int>(species.members.size());
        population.species.push_back(std::move(species));
    }
    if (placed != static_cast<int>(population.genomes.size())) reader.refuse("a genome is of no species");
    if (marked > 1) reader.refuse("two species hold the mark of the best");
}

void load_genomes(const NetworkShape &shape, int size, Population &population, StateReader &reader) {
    population.genomes = planula::load_genomes(shape.inputs, shape.outputs, population.innovations, reader);
    if (population.genomes.size() != static_cast<std::size_t>(size))
        reader.refuse("the population has not the setting's size of " + to_text(size));
    std::set<std::int64_t> ids;
    for (const Genome &genome : population.genomes) {
        check_member(genome, shape, population, reader);
        if (!ids.insert(genome.id).second) reader.refuse("two genomes have one id");
    }
}

} // namespace

void check_member(const Genome &genome, const NetworkShape &shape, const Population &population,
                  const StateReader &reader) {
    if (std::max({genome.id, genome.mother, genome.father}) >= population.next_genome)
        reader.refuse("a genome, or a parent, is not born yet");
    if (shape.recurrent) return;
    for (const LinkGene &link : genome.links) {
        const double climb = genome.find_node(link.to)->depth - genome.find_node(link.from)->depth;
        if (link.recurrent || climb <= 0)
            reader.refuse("a link of a network without recurrence does not climb");
    }
}

void save(const Population &population, StateWriter &writer) {
    CHECK(is_complete(population), population.generation);
    writer.group("population").integer(population.generation);
    writer.real(population.threshold).real(population.best_ever);
    writer.integer(population.next_genome).integer(population.next_species);
    writer.integer(population.genomes.front().inputs).integer(population.genomes.front().outputs);
    population.innovations.save(writer);
    save(population.genomes, population.innovations, writer);
    writer.group("species").integer(static_cast<std::int64_t>(population.species.size()));
    for (const Species &species : population.species) save(species, writer);
}

Population load_population(const NetworkShape &shape, int size, int generations, StateReader &reader) {
    Population population;
    reader.group("population");
    population.generation = static_cast<int>(reader.integer(0, std::int64_t{generations} - 1));
    population.threshold = reader.finite();
    if (population.threshold < 0) reader.refuse("the compatibility threshold is below 0");
    population.best_ever = load_score(reader);
    population.next_genome = reader.integer(0, most_genomes);
    population.next_species = static_cast<int>(reader.integer(0, std::numeric_limits<int>::max() / 2));
    const std::int64_t inputs = reader.integer(), outputs = reader.integer();
    if (inputs != shape.inputs || outputs != shape.outputs)
        reader.refuse("the genomes have not the inputs and outputs of the setting");
    population.innovations = Innovations::load(reader);
    if (population.innovations.first_node() != shape.inputs + shape.outputs)
        reader.refuse("the innovations are of networks of another shape");
    load_genomes(shape, size, population, reader);
    reader.group("species");
    load_all_species(population, reader);
    return population;
}

} // namespace planula
