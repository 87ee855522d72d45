// SPDX-License-Identifier: MIT
// The search for fitness, plain NEAT (§2.7.1): an individual's score is its fitness, shared within species.
#pragma once

#include "evolution/search.h"

namespace planula {

class FitnessSearch final : public Search {
  public:
    /// The fitness of each valid individual, in which the penalty is already contained; 0 for all others.
    std::vector<double> score(const Population &population, std::span<const Evaluation> evaluations) override;
    bool shares_fitness() const override { return true; }
    void save(StateWriter &writer) const override;
    void load(StateReader &reader) override;
};

} // namespace planula
