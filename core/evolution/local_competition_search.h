// SPDX-License-Identifier: MIT
// Novelty search with local competition (Lehman & Stanley 2011, "Evolving a diversity of virtual creatures through
// novelty search and local competition", GECCO): an individual competes with those that behave like it, so that every
// way of behaving is improved by its own measure. NSGA-II with three objectives: novelty, local competition and
// genotypic diversity. Individuals compete by fitness; where an experiment states objectives, by each of these, which
// makes one objective of local competition each. Genotypic diversity takes the place of crowding in the space of
// objectives, which would conflate individuals that differ but have equal scores.
#pragma once

#include "evolution/pareto_search.h"

namespace planula {

class LocalCompetitionSearch final : public ParetoSearch {
  public:
    explicit LocalCompetitionSearch(const Parameters &parameters)
        : ParetoSearch("local competition search", parameters) {}

    /// Throws InputError if novelty is stated as an objective.
    bool take(const Aims &aims) override;
    /// Novelty × penalty; the number of neighbours, the same that novelty is measured by, with lower fitness, or worse
    /// by each stated objective; the mean distance δ (genome/distance.h) to the valid others of the pool.
    std::vector<Objectives> objectives(const Elites &pool, const NeighbourLists &neighbours,
                                       const NoveltyArchive &archive) const override;
    std::vector<double> diversity(std::span<const Objectives> objectives,
                                  std::span<const int> front) const override;
};

} // namespace planula
