// SPDX-License-Identifier: MIT
#include "evolution/map_elites_search.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

namespace planula {

bool MapElitesSearch::take(const Aims &aims) {
    const auto has_range = [](const DescriptorNumber &number) { return number.cells > 0; };
    const auto ranges = std::count_if(aims.descriptor.begin(), aims.descriptor.end(), has_range);
    if (ranges != 0 && ranges != std::ssize(aims.descriptor))
        throw InputError(
            "search 'map-elites' takes from, to and cells for every number of the descriptor, or for none");
    if (ranges != 0) ranges_ = aims.descriptor;
    return Search::take(aims);
}

std::vector<double> MapElitesSearch::score(const Population &population,
                                           std::span<const Evaluation> evaluations) {
    CHECK(evaluations.size() == population.genomes.size(), evaluations.size(), population.genomes.size());
    check_behaviours(evaluations, length_);
    if (!ranges_.empty() && length_ != 0 && length_ != ranges_.size())
        throw InputError("the descriptor has ranges of " + to_text(std::int64_t(ranges_.size())) +
                         " numbers, but behaviours have " + to_text(std::int64_t(length_)));
    std::vector<double> scores(evaluations.size());
    for (std::size_t slot = 0; slot < evaluations.size(); ++slot) {
        const Genome &genome = population.genomes[slot];
        const Evaluation &evaluation = evaluations[slot];
        if (!evaluation.valid() || !enters(evaluation)) continue;
        scores[slot] = enter(genome, evaluation);
        archive_.push_back(
            {population.generation, genome.id, evaluation.behaviour, scores[slot], evaluation.fitness});
    }
    return scores;
}

MapElitesSearch::Niche MapElitesSearch::niche_of(const Evaluation &evaluation) const {
    Niche niche;
    for (std::size_t i = 0; i < evaluation.behaviour.size(); ++i) {
        const double value = evaluation.behaviour[i];
        niche.push_back(ranges_.empty() ? std::floor(value / niche_width_)
                                        : planula::niche_of(ranges_[i], value));
    }
    return niche;
}

bool MapElitesSearch::enters(const Evaluation &evaluation) const {
    const auto found = niches_.find(niche_of(evaluation));
    return found == niches_.end() || evaluation.fitness > elites_.evaluations[found->second].fitness;
}

double MapElitesSearch::enter(const Genome &genome, const Evaluation &evaluation) {
    const auto [entry, is_new] = niches_.try_emplace(niche_of(evaluation), elites_.size());
    if (is_new) {
        elites_.add(genome, evaluation);
        return evaluation.fitness;
    }
    const double before = elites_.evaluations[entry->second].fitness;
    elites_.genomes[entry->second] = genome;
    elites_.evaluations[entry->second] = evaluation;
    return evaluation.fitness - before;
}

Population MapElitesSearch::next(const Population &population, std::span<const double> scores,
                                 const NetworkShape &shape, std::uint64_t seed) const {
    std::vector<double> fitness;
    for (const Evaluation &evaluation : elites_.evaluations) fitness.push_back(evaluation.fitness);
    const Parents parents =
        elites_.size() > 0 ? Parents{elites_.genomes, fitness, {}} : Parents{population.genomes, scores, {}};
    const auto any = [&](Stream &stream) {
        return static_cast<int>(stream.below(static_cast<std::uint32_t>(parents.genomes.size())));
    };
    return brood(population, parents, any, shape.recurrent, neat_, seed);
}

void MapElitesSearch::save(const Population &population, StateWriter &writer) const {
    writer.group("map-elites search");
    planula::save(elites_, population.innovations, writer);
    writer.group("archive").integer(static_cast<std::int64_t>(length_));
    writer.integer(static_cast<std::int64_t>(archive_.size()));
}

void MapElitesSearch::load(const Population &population, std::span<const ArchiveEntry> archive,
                           StateReader &reader) {
    const std::vector<DescriptorNumber> ranges = ranges_;
    *this = MapElitesSearch(neat_, niche_width_);
    ranges_ = ranges;
    reader.group("map-elites search");
    const Elites elites = load_elites(population, reader);
    reader.group("archive");
    constexpr int largest = std::numeric_limits<int>::max();
    length_ = static_cast<std::size_t>(reader.integer(0, largest));
    check_archive(archive, static_cast<std::size_t>(reader.integer(0, largest)), length_, reader);
    archive_.assign(archive.begin(), archive.end());

    // The map follows from its elites.
    for (std::size_t i = 0; i < elites.size(); ++i) {
        const Evaluation &evaluation = elites.evaluations[i];
        if (!evaluation.valid() || evaluation.behaviour.empty() || evaluation.behaviour.size() != length_)
            reader.refuse("an elite has no niche");
        if (!ranges_.empty() && length_ != ranges_.size())
            reader.refuse("an elite has a niche of another map");
        if (niches_.contains(niche_of(evaluation))) reader.refuse("two elites share a niche");
        enter(elites.genomes[i], evaluation);
    }
}

std::unique_ptr<Search> map_elites_search(const Parameters &parameters) {
    return std::make_unique<MapElitesSearch>(parameters);
}

} // namespace planula
