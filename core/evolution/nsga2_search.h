// SPDX-License-Identifier: MIT
// The objectives that an experiment states, by NSGA-II (Deb et al. 2002); without any, fitness and novelty, as Mouret
// (2011, "Novelty-based multiobjectivization", in New Horizons in Evolutionary Robotics) combined them. No individual is
// preferred that is worse than another in all of them. Within a front, crowding in the space of the objectives decides.
#pragma once

#include "evolution/pareto_search.h"

namespace planula {

class Nsga2Search final : public ParetoSearch {
  public:
    explicit Nsga2Search(const Parameters &parameters) : ParetoSearch("nsga2 search", parameters) {}

    /// Those stated, or fitness, in which the penalty is already contained, and novelty × penalty.
    std::vector<Objectives> objectives(const Elites &pool, const NeighbourLists &neighbours,
                                       const NoveltyArchive &archive) const override;
    std::vector<double> diversity(std::span<const Objectives> objectives,
                                  std::span<const int> front) const override;
};

} // namespace planula
