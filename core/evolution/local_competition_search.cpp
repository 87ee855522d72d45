// SPDX-License-Identifier: MIT
#include "evolution/local_competition_search.h"

#include "base/error.h"
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

bool LocalCompetitionSearch::take(const Aims &aims) {
    for (const Objective &objective : aims.objectives)
        if (objective.value == Objective::Value::novelty)
            throw InputError(
                "novelty is an objective of search 'nslc' already; state what individuals compete by");
    return ParetoSearch::take(aims);
}

std::vector<Objectives> LocalCompetitionSearch::objectives(const Elites &pool,
                                                           const NeighbourLists &neighbours,
                                                           const NoveltyArchive &archive) const {
    static const std::vector<Objective> fitness_alone{{"fitness", Objective::Value::fitness, {}}};
    const std::vector<Objective> &aims = aims_.objectives.empty() ? fitness_alone : aims_.objectives;
    // What an individual of the pool or the archive is worth, by each aim.
    const auto worth = [&](std::size_t index) {
        if (index < pool.size())
            return worths(aims, pool.evaluations[index].fitness, 0, pool.evaluations[index].objectives);
        const ArchiveEntry &entry = archive.entries()[index - pool.size()];
        return worths(aims, entry.fitness, 0, entry.objectives);
    };
    const std::vector<double> genotypic = genotypic_diversity(pool, neat_);
    std::vector<Objectives> result(pool.size());
    for (std::size_t i = 0; i < pool.size(); ++i) {
        const Evaluation &evaluation = pool.evaluations[i];
        if (!evaluation.valid()) continue;
        const std::vector<double> own = worth(i);
        std::vector<double> beaten(aims.size());
        for (const Neighbour &neighbour : neighbours[i]) {
            const std::vector<double> other = worth(neighbour.index);
            for (std::size_t aim = 0; aim < aims.size(); ++aim) beaten[aim] += other[aim] < own[aim];
        }
        result[i] = {novelty(neighbours[i]) * evaluation.penalty};
        result[i].insert(result[i].end(), beaten.begin(), beaten.end());
        result[i].push_back(genotypic[i]);
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
