// SPDX-License-Identifier: MIT
// The search for fitness, plain NEAT (§2.7.1): an individual's score is its fitness, shared within species.
#pragma once

#include "evolution/search.h"

namespace planula {

class FitnessSearch final : public Search {
  public:
    explicit FitnessSearch(const Parameters &parameters) : neat_(parameters.neat) {}

    /// The fitness of each valid individual, in which the penalty is already contained; 0 for all others.
    std::vector<double> score(const Population &population, std::span<const Evaluation> evaluations) override;
    Population next(const Population &population, std::span<const double> scores, const NetworkShape &shape,
                    std::uint64_t seed) const override;
    void save(const Population &population, StateWriter &writer) const override;
    void load(const Population &population, std::span<const ArchiveEntry> archive,
              StateReader &reader) override;

  private:
    NeatParameters neat_;
};

} // namespace planula
