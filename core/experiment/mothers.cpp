// SPDX-License-Identifier: MIT
#include "experiment/mothers.h"

#include "base/check.h"

#include <algorithm>
#include <limits>
#include <set>

namespace planula {

namespace {

bool is_changed(const Genome &child) {
    return child.origin == Origin::mutation || child.origin == Origin::crossover ||
           child.origin == Origin::crossover_mutation;
}

/// The genomes of all whose lives are asked for in this population, or may be in a later one.
std::set<std::int64_t> wanted(const Population &population, std::span<const Genome> kept) {
    std::set<std::int64_t> ids;
    for (const Genome &child : population.genomes)
        if (is_changed(child)) ids.insert(child.mother);
    for (const Genome &genome : kept) ids.insert(genome.id);
    return ids;
}

} // namespace

const MotherLife *Mothers::of(const Genome &child) const {
    const auto found = is_changed(child) ? lives_.find(child.mother) : lives_.end();
    return found == lives_.end() ? nullptr : &found->second;
}

void Mothers::add(const Population &population, std::span<const Life> lives,
                  std::span<const Evaluation> evaluations) {
    const std::size_t size = population.genomes.size();
    CHECK(lives.size() == size && evaluations.size() == size, size, lives.size(), evaluations.size());
    for (std::size_t slot = 0; slot < size; ++slot)
        lives_[population.genomes[slot].id] = {evaluations[slot].fitness, lives[slot].cells};
}

void Mothers::keep(const Population &population, std::span<const Genome> kept) {
    const std::set<std::int64_t> ids = wanted(population, kept);
    std::erase_if(lives_, [&](const auto &entry) { return !ids.contains(entry.first); });
    CHECK(lives_.size() == ids.size(), lives_.size(), ids.size());
}

void Mothers::save(StateWriter &writer) const {
    writer.group("mothers").integer(static_cast<std::int64_t>(lives_.size()));
    for (const auto &[genome, life] : lives_) writer.integer(genome).real(life.fitness).integer(life.cells);
}

Mothers Mothers::load(const Population &population, std::span<const Genome> kept, StateReader &reader) {
    constexpr std::size_t least_bytes = 24;
    const std::set<std::int64_t> ids = wanted(population, kept);
    reader.group("mothers");
    if (reader.count(least_bytes) != ids.size()) reader.refuse("there are not as many as have children");
    Mothers mothers;
    for (const std::int64_t id : ids) {
        if (reader.integer() != id) reader.refuse("a mother has no children");
        MotherLife &life = mothers.lives_[id];
        life.fitness = reader.finite();
        if (life.fitness < 0) reader.refuse("a fitness is below 0");
        life.cells = static_cast<int>(reader.integer(0, std::numeric_limits<int>::max()));
    }
    return mothers;
}

} // namespace planula
