// SPDX-License-Identifier: MIT
#include "evolution/novelty_search.h"

#include "base/check.h"
#include "evolution/reproduce.h"

namespace planula {

std::vector<double> NoveltySearch::score(const Population &population,
                                         std::span<const Evaluation> evaluations) {
    CHECK(evaluations.size() == population.genomes.size(), evaluations.size(), population.genomes.size());
    std::vector<double> scores;
    for (const auto &neighbours : archive_.neighbours(evaluations)) scores.push_back(novelty(neighbours));
    archive_.extend(population, evaluations, scores);
    for (std::size_t slot = 0; slot < scores.size(); ++slot) scores[slot] *= evaluations[slot].penalty;
    return scores;
}

Population NoveltySearch::next(const Population &population, std::span<const double> scores,
                               const NetworkShape &shape, std::uint64_t seed) const {
    const bool aged = species_ == NoveltySpecies::aged;
    return reproduce(population, scores, aged ? Adjustment::age : Adjustment::none, shape.recurrent, neat_,
                     seed);
}

void NoveltySearch::save(const Population &, StateWriter &writer) const {
    writer.group("novelty search");
    archive_.save(writer);
}

void NoveltySearch::load(const Population &, std::span<const ArchiveEntry> archive, StateReader &reader) {
    reader.group("novelty search");
    archive_.load(reader, archive);
}

std::unique_ptr<Search> novelty_search(const Parameters &parameters) {
    return std::make_unique<NoveltySearch>(parameters);
}

} // namespace planula
