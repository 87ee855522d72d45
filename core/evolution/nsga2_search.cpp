// SPDX-License-Identifier: MIT
#include "evolution/nsga2_search.h"

namespace planula {

std::vector<Objectives> Nsga2Search::objectives(const Elites &pool, const NeighbourLists &neighbours,
                                                const NoveltyArchive &) const {
    std::vector<Objectives> result(pool.size());
    for (std::size_t i = 0; i < pool.size(); ++i) {
        const Evaluation &evaluation = pool.evaluations[i];
        if (!evaluation.valid()) continue;
        const double new_by = novelty(neighbours[i]) * evaluation.penalty;
        result[i] = aims_.objectives.empty()
                        ? Objectives{evaluation.fitness, new_by}
                        : worths(aims_.objectives, evaluation.fitness, new_by, evaluation.objectives);
    }
    return result;
}

std::vector<double> Nsga2Search::diversity(std::span<const Objectives> objectives,
                                           std::span<const int> front) const {
    return crowding_distances(objectives, front);
}

std::unique_ptr<Search> nsga2_search(const Parameters &parameters) {
    return std::make_unique<Nsga2Search>(parameters);
}

} // namespace planula
