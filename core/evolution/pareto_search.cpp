// SPDX-License-Identifier: MIT
#include "evolution/pareto_search.h"

#include "base/check.h"
#include "base/error.h"

#include <algorithm>

namespace planula {

bool ParetoSearch::take(const Aims &aims) {
    aims_ = aims;
    return true;
}

std::vector<double> ParetoSearch::score(const Population &population,
                                        std::span<const Evaluation> evaluations) {
    CHECK(evaluations.size() == population.genomes.size(), evaluations.size(), population.genomes.size());
    check_objectives(evaluations, aims_.stated());
    Elites pool = kept_;
    for (std::size_t slot = 0; slot < evaluations.size(); ++slot)
        pool.add(population.genomes[slot], evaluations[slot]);

    // Rank all by the archive as it is; only then do the new ones enter it.
    const NeighbourLists neighbours = archive_.neighbours(pool.evaluations);
    const std::vector<int> order = ranked(objectives(pool, neighbours, archive_));
    std::vector<double> novelties;
    for (std::size_t i = kept_.size(); i < pool.size(); ++i) novelties.push_back(novelty(neighbours[i]));
    archive_.extend(population, evaluations, novelties);

    // Those of the generation are behind those kept before.
    std::vector<double> scores(evaluations.size());
    for (std::size_t place = 0; place < order.size(); ++place)
        if (const std::size_t who = order[place]; who >= kept_.size())
            scores[who - kept_.size()] = static_cast<double>(order.size() - 1 - place);
    kept_ = Elites();
    for (std::size_t place = 0; place < std::min<std::size_t>(order.size(), neat_.population); ++place)
        kept_.add(pool.genomes[order[place]], pool.evaluations[order[place]]);
    return scores;
}

/// All solutions, by the crowded-comparison operator; equals keep their order.
std::vector<int> ParetoSearch::ranked(std::span<const Objectives> objectives) const {
    std::vector<int> order;
    for (const std::vector<int> &front : non_dominated_fronts(objectives)) {
        std::vector<double> value(objectives.size());
        const bool feasible = !objectives[front.front()].empty();
        const std::vector<double> apart =
            feasible ? diversity(objectives, front) : std::vector<double>(front.size());
        for (std::size_t i = 0; i < front.size(); ++i) value[front[i]] = apart[i];
        order.insert(order.end(), front.begin(), front.end());
        std::stable_sort(order.end() - static_cast<std::ptrdiff_t>(front.size()), order.end(),
                         [&](int a, int b) { return value[a] > value[b]; });
    }
    return order;
}

Population ParetoSearch::next(const Population &population, std::span<const double>,
                              const NetworkShape &shape, std::uint64_t seed) const {
    std::vector<double> ranks;
    for (std::size_t left = kept_.size(); left > 0; --left) ranks.push_back(static_cast<double>(left));
    // Of two drawn, the one of higher rank, which comes first in kept_.
    const auto tournament = [&](Stream &stream) {
        const auto size = static_cast<std::uint32_t>(kept_.size());
        const std::uint32_t one = stream.below(size), other = stream.below(size);
        return static_cast<int>(std::min(one, other));
    };
    return brood(population, {kept_.genomes, ranks, {}}, tournament, shape.recurrent, neat_, seed);
}

void ParetoSearch::save(const Population &population, StateWriter &writer) const {
    writer.group(name_);
    archive_.save(writer);
    planula::save(kept_, population.innovations, writer);
    // Runs without stated objectives have no such part.
    if (aims_.stated() == 0) return;
    writer.group("objectives");
    for (const Evaluation &evaluation : kept_.evaluations)
        for (const double value : evaluation.objectives) writer.real(value);
}

void ParetoSearch::load(const Population &population, std::span<const ArchiveEntry> archive,
                        StateReader &reader) {
    reader.group(name_);
    archive_.load(reader, archive);
    kept_ = load_elites(population, reader);
    const std::size_t stated = aims_.stated();
    for (const ArchiveEntry &entry : archive)
        if (entry.objectives.size() != stated) reader.refuse("an entry of the archive lacks objectives");
    if (stated == 0) return;
    reader.group("objectives");
    for (Evaluation &evaluation : kept_.evaluations)
        for (std::size_t i = 0; evaluation.valid() && i < stated; ++i)
            evaluation.objectives.push_back(reader.finite());
}

} // namespace planula
