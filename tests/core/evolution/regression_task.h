// SPDX-License-Identifier: MIT
// A task that needs no simulator: six (five) outputs shall take given values for one given input. It was also
// given to MultiNEAT at d361660, the library and revision of the paper, with the values of the parameters
// here, so that its populations and ours can be compared generation by generation.
#pragma once

#include "evolution/fitness_search.h"
#include "evolution/population.h"
#include "evolution/reproduce.h"

#include "base/math.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace planula::regression {

inline constexpr std::array<double, 9> input{0.5, -0.3, 0.8, 0.1, -0.7, 0.4, -0.2, 0.6, 1.0};
inline constexpr std::array<double, 6> target{0.6, -0.4, 0.2, -0.8, 0.5, -0.1};

inline NetworkShape shape(bool recurrent) { return {9, recurrent ? 5 : 6, recurrent}; }

inline std::size_t place_of(const Genome &genome, int id) {
    return static_cast<std::size_t>(genome.find_node(id) - genome.nodes.data());
}

/// The longest path in links of an acyclic genome.
inline int depth(const Genome &genome) {
    std::vector<int> longest(genome.nodes.size(), 0);
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto &link : genome.links) {
            const int through = longest[place_of(genome, link.from)] + 1;
            int &known = longest[place_of(genome, link.to)];
            changed |= through > known;
            known = std::max(known, through);
        }
    }
    return *std::max_element(longest.begin(), longest.end());
}

/// Activations after a number of synchronous steps from rest.
inline std::vector<double> activate(const Genome &genome, int steps) {
    std::vector<double> state(genome.nodes.size(), 0);
    std::copy(input.begin(), input.end(), state.begin());
    for (int step = 0; step < steps; ++step) {
        std::vector<double> sums(genome.nodes.size(), 0);
        for (const auto &link : genome.links)
            sums[place_of(genome, link.to)] += link.weight * state[place_of(genome, link.from)];
        for (std::size_t node = input.size(); node < sums.size(); ++node)
            state[node] = math::tanh(sums[node]);
    }
    return state;
}

/// 10 − Σ (output − target)², never below 0.
inline double fitness(const Genome &genome, bool recurrent) {
    const std::vector<double> state = activate(genome, recurrent ? 5 : depth(genome));
    double error = 0;
    for (int i = 0; i < genome.outputs; ++i) {
        const double difference = state[input.size() + i] - target[i];
        error += difference * difference;
    }
    return std::max(0.0, 10 - error);
}

/// One row of the comparison: a generation as it was evaluated.
struct Row {
    double shortfall, mean_fitness, species, threshold, links, hidden, weight_deviation, largest;
};

inline Row describe(const Population &population, const std::vector<double> &scores) {
    Row row{10 - *std::max_element(scores.begin(), scores.end()), 0, 0, population.threshold, 0, 0, 0, 0};
    double sum = 0, squares = 0, links = 0;
    for (std::size_t slot = 0; slot < scores.size(); ++slot) {
        row.mean_fitness += scores[slot] / static_cast<double>(scores.size());
        row.hidden += population.genomes[slot].hidden() / static_cast<double>(scores.size());
        for (const auto &link : population.genomes[slot].links) {
            sum += link.weight, squares += link.weight * link.weight;
            ++links;
        }
    }
    row.links = links / static_cast<double>(scores.size());
    row.weight_deviation = std::sqrt(squares / links - sum / links * (sum / links));
    row.species = static_cast<double>(population.species.size());
    for (const auto &species : population.species)
        row.largest = std::max(row.largest, static_cast<double>(species.members.size()));
    return row;
}

/// Rows of generations 0 … last.
inline std::vector<Row> evolve(bool recurrent, int last, std::uint64_t seed) {
    Parameters parameters; // the library's, as its reference values are
    parameters.neat.start_weight = parameters.neat.weight_power = 1;
    parameters.neat.weight_step = 0;
    Population population = initial_population(shape(recurrent), parameters.neat, seed);
    std::vector<Row> rows;
    for (;;) {
        std::vector<double> scores;
        for (const auto &genome : population.genomes) scores.push_back(fitness(genome, recurrent));
        rows.push_back(describe(population, scores));
        if (population.generation == last) return rows;
        population = reproduce(population, scores, Adjustment::sharing, recurrent, parameters.neat, seed);
    }
}

} // namespace planula::regression
