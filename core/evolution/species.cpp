// SPDX-License-Identifier: MIT
#include "evolution/species.h"

#include "base/check.h"
#include "genome/distance.h"

#include <algorithm>
#include <utility>

namespace planula {

namespace {

/// The first compatible species, or the end of the list.
std::vector<Species>::iterator find_species(const NeatParameters &parameters, Population &population,
                                            const Genome &child) {
    return std::find_if(population.species.begin(), population.species.end(), [&](const Species &species) {
        return distance(child, species.representative, parameters) <= population.threshold;
    });
}

void fill(int size, Population &population) {
    Species &first = population.species.front();
    while (static_cast<int>(population.genomes.size()) < size) {
        Genome copy = population.genomes[first.members.front()];
        copy.mother = copy.id;
        copy.father = -1;
        copy.origin = Origin::filler;
        copy.id = population.next_genome++;
        first.members.push_back(static_cast<int>(population.genomes.size()));
        population.genomes.push_back(std::move(copy));
    }
}

} // namespace

void add_child(const NeatParameters &parameters, Population &population, Genome child) {
    child.id = population.next_genome++;
    auto home = find_species(parameters, population, child);
    if (home == population.species.end()) {
        Species founded;
        founded.id = population.next_species++;
        founded.representative = child;
        home = population.species.insert(home, std::move(founded));
    }
    home->members.push_back(static_cast<int>(population.genomes.size()));
    population.genomes.push_back(std::move(child));
}

void complete_generation(int size, Population &population) {
    const int born = static_cast<int>(population.genomes.size());
    CHECK(born >= 1 && born <= size, born, size);
    std::erase_if(population.species, [](const Species &species) { return species.members.empty(); });
    fill(size, population);

    // From order of birth to slot order.
    std::vector<Genome> slots;
    slots.reserve(population.genomes.size());
    for (auto &species : population.species) {
        for (int &member : species.members) {
            slots.push_back(std::move(population.genomes[member]));
            member = static_cast<int>(slots.size()) - 1;
        }
        species.representative = slots[species.members.front()];
    }
    population.genomes = std::move(slots);
}

} // namespace planula
