// SPDX-License-Identifier: MIT
// A run of any search on a toy problem: what an individual does follows from the weights of its genome.
#pragma once

#include "core/evolution/populations.h"
#include "evolution/brood.h"
#include "evolution/search.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace planula {

using Ids = std::vector<std::int64_t>;

/// A generation of equal genomes with ids from `first` on.
inline Population numbered(int size, std::int64_t first) {
    Population population = populations::of({std::vector<double>(size, 1)});
    for (Genome &genome : population.genomes) genome.id = first++;
    return population;
}

inline Ids ids(const Elites &elites) {
    Ids result;
    for (const Genome &genome : elites.genomes) result.push_back(genome.id);
    return result;
}

using Judgement = std::function<Evaluation(const Genome &)>;

/// Behaves by the sums of every other weight; a tenth or so are invalid, some carry a penalty.
inline Evaluation by_weights(const Genome &genome) {
    double sums[2] = {0, 0};
    for (const LinkGene &link : genome.links) sums[link.innovation % 2] += link.weight;
    const double first = genome.links.front().weight;
    const double penalty = first < -0.8 ? 0 : first < -0.4 ? 0.1 : 1;
    return {std::max(0.0, 10 + sums[0] - sums[1] * sums[1]) * penalty, {sums[0], sums[1]}, penalty};
}

struct ToyRun {
    ToyRun(std::string_view name, const Parameters &p, std::uint64_t seed_, Judgement judge_ = by_weights,
           const Aims &aims = {})
        : parameters(p), seed(seed_), judge(std::move(judge_)), search(make_search(name, p, aims)),
          population(initial_population(shape, p.neat, seed_)) {}

    /// Scores this generation and makes the next.
    void step() {
        evaluations.clear();
        for (const Genome &genome : population.genomes) evaluations.push_back(judge(genome));
        scores = search->score(population, evaluations);
        population = search->next(population, scores, shape, seed);
    }
    /// Everything that a number of generations did.
    std::vector<std::pair<std::vector<Genome>, std::vector<double>>> steps(int generations) {
        std::vector<std::pair<std::vector<Genome>, std::vector<double>>> history;
        for (int i = 0; i < generations; ++i) {
            step();
            history.emplace_back(population.genomes, scores);
        }
        return history;
    }

    static constexpr NetworkShape shape{3, 2, false};
    Parameters parameters;
    std::uint64_t seed;
    Judgement judge;
    std::unique_ptr<Search> search;
    Population population;
    std::vector<Evaluation> evaluations;
    std::vector<double> scores;
};

} // namespace planula
