// SPDX-License-Identifier: MIT
// Populations to test with, species by species.
#pragma once

#include "core/genome/specimens.h"
#include "evolution/population.h"

#include <vector>

namespace planula::populations {

/// Input 0, the bias 1 and output 2; one link with this weight.
inline Genome with_weight(double weight, Innovations &innovations) {
    Genome genome = specimens::bare(2, 1);
    genome.links = {{innovations.link(0, 2), 0, 2, weight, false}};
    return genome;
}

/// Species i has one member for each of weights[i] and is represented by the first.
inline Population of(const std::vector<std::vector<double>> &weights) {
    Population population;
    population.generation = 7;
    population.threshold = 5;
    population.innovations = Innovations(3);
    for (const auto &each : weights) {
        Species species;
        species.id = population.next_species++;
        for (const double weight : each) {
            species.members.push_back(static_cast<int>(population.genomes.size()));
            population.genomes.push_back(with_weight(weight, population.innovations));
            population.genomes.back().id = population.next_genome++;
        }
        species.representative = population.genomes[species.members.front()];
        population.species.push_back(species);
    }
    return population;
}

/// Species i has sizes[i] equal members, far from those of all others.
inline Population far_apart(const std::vector<int> &sizes) {
    std::vector<std::vector<double>> weights;
    for (std::size_t i = 0; i < sizes.size(); ++i)
        weights.emplace_back(sizes[i], 8 - 16.0 * static_cast<double>(i) / 15);
    return of(weights);
}

/// Children are copies of their mothers, so that species sizes are quotas; far_apart() is far enough.
inline Parameters frozen(int population) {
    Parameters parameters;
    parameters.neat.population = population;
    parameters.neat.add_node_rate = parameters.neat.add_link_rate = parameters.neat.remove_link_rate = 0;
    parameters.neat.weight_power = parameters.neat.weight_severe_rate = 0;
    parameters.neat.crossover_rate = 0;
    parameters.neat.clone_tries = 1;
    parameters.neat.weight_coefficient = 100;
    return parameters;
}

inline std::vector<int> sizes(const Population &population) {
    std::vector<int> result;
    for (const auto &species : population.species) result.push_back(static_cast<int>(species.members.size()));
    return result;
}

} // namespace planula::populations
