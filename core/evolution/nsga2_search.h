// SPDX-License-Identifier: MIT
// Fitness and novelty as two objectives of NSGA-II (Deb et al. 2002), as Mouret (2011, "Novelty-based
// multiobjectivization", in New Horizons in Evolutionary Robotics) combined them: no individual is preferred that is
// both less fit and less novel than another. Within a front, crowding in the space of the objectives decides.
#pragma once

#include "evolution/pareto_search.h"

namespace planula {

class Nsga2Search final : public ParetoSearch {
  public:
    explicit Nsga2Search(const Parameters &parameters) : ParetoSearch("nsga2 search", parameters) {}

    /// Fitness, in which the penalty is already contained, and novelty × penalty.
    std::vector<Objectives> objectives(const Elites &pool, const NeighbourLists &neighbours,
                                       const NoveltyArchive &archive) const override;
    std::vector<double> diversity(std::span<const Objectives> objectives,
                                  std::span<const int> front) const override;
};

} // namespace planula
