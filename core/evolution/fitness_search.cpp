// SPDX-License-Identifier: MIT
#include "evolution/fitness_search.h"

#include "base/check.h"
#include "evolution/reproduce.h"

#include <cmath>

namespace planula {

std::vector<double> FitnessSearch::score(const Population &population,
                                         std::span<const Evaluation> evaluations) {
    CHECK(evaluations.size() == population.genomes.size(), evaluations.size(), population.genomes.size());
    std::vector<double> scores;
    for (const auto &evaluation : evaluations) {
        scores.push_back(evaluation.valid() ? evaluation.fitness : 0);
        CHECK(scores.back() >= 0 && std::isfinite(scores.back()), scores.back());
    }
    return scores;
}

Population FitnessSearch::next(const Population &population, std::span<const double> scores,
                               const NetworkShape &shape, std::uint64_t seed) const {
    return reproduce(population, scores, Adjustment::sharing, shape.recurrent, neat_, seed);
}

void FitnessSearch::save(const Population &, StateWriter &writer) const { writer.group("fitness search"); }

void FitnessSearch::load(const Population &, std::span<const ArchiveEntry> archive, StateReader &reader) {
    reader.group("fitness search");
    check_archive(archive, 0, 0, reader);
}

std::unique_ptr<Search> fitness_search(const Parameters &parameters) {
    return std::make_unique<FitnessSearch>(parameters);
}

} // namespace planula
