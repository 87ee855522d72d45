// SPDX-License-Identifier: MIT
#include "evolution/local_competition_search.h"

#include "genome/distance.h"

#include <algorithm>

namespace planula {

namespace {

/// Of each valid genome, the mean distance to the valid others, summed in order; 0 without any.
std::vector<double> genotypic_diversity(const Elites &pool, const NeatParameters &parameters) {
    std::vector<std::size_t> valid;
    std::vector<const Genome *> genomes;
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (pool.evaluations[i].valid()) valid.push_back(i), genomes.push_back(&pool.genomes[i]);
    const std::vector<double> sums = distance_sums(genomes, parameters);
    std::vector<double> result(pool.size());
    for (std::size_t i = 0; i < valid.size(); ++i)
        result[valid[i]] = sums[i] / std::max(1.0, static_cast<double>(valid.size()) - 1);
    return result;
}

} // namespace

std::vector<Objectives> LocalCompetitionSearch::objectives(const Elites &pool,
                                                           const NeighbourLists &neighbours,
                                                           const NoveltyArchive &archive) const {
    const auto fitness = [&](std::size_t index) {
        return index < pool.size() ? pool.evaluations[index].fitness
                                   : archive.entries()[index - pool.size()].fitness;
    };
    const std::vector<double> genotypic = genotypic_diversity(pool, neat_);
    std::vector<Objectives> result(pool.size());
    for (std::size_t i = 0; i < pool.size(); ++i) {
        const Evaluation &evaluation = pool.evaluations[i];
        if (!evaluation.valid()) continue;
        const auto beaten =
            std::count_if(neighbours[i].begin(), neighbours[i].end(), [&](const Neighbour &neighbour) {
                return fitness(neighbour.index) < evaluation.fitness;
            });
        result[i] = {novelty(neighbours[i]) * evaluation.penalty, static_cast<double>(beaten), genotypic[i]};
    }
    return result;
}

std::vector<double> LocalCompetitionSearch::diversity(std::span<const Objectives> objectives,
                                                      std::span<const int> front) const {
    std::vector<double> result;
    for (const int who : front) result.push_back(objectives[who].back());
    return result;
}

std::unique_ptr<Search> local_competition_search(const Parameters &parameters) {
    return std::make_unique<LocalCompetitionSearch>(parameters);
}

} // namespace planula
