// SPDX-License-Identifier: MIT
// Novelty search (Lehman & Stanley 2011; §2.7.2; decision 0014): an individual is rewarded for behaving unlike the
// others of its generation and those in an archive of the past. ρ = mean Euclidean distance to the k nearest
// behaviours, Eq. (7). Fitness is never read; an invalid individual is as if it did not exist.
#pragma once

#include "evolution/search.h"

namespace planula {

class NoveltySearch final : public Search {
  public:
    explicit NoveltySearch(const Parameters &parameters)
        : neat_(parameters.neat), species_(parameters.novelty.novelty_species), archive_(parameters.novelty) {
    }

    /// ρ × penalty; 0 for invalid individuals. Throws InputError as check_behaviours() does.
    std::vector<double> score(const Population &population, std::span<const Evaluation> evaluations) override;
    Population next(const Population &population, std::span<const double> scores, const NetworkShape &shape,
                    std::uint64_t seed) const override;
    bool keeps_archive() const override { return true; }
    std::span<const ArchiveEntry> archive() const override { return archive_.entries(); }
    double archive_threshold() const override { return archive_.threshold(); }
    void save(const Population &population, StateWriter &writer) const override;
    void load(const Population &population, std::span<const ArchiveEntry> archive,
              StateReader &reader) override;

  private:
    NeatParameters neat_;
    NoveltySpecies species_;
    NoveltyArchive archive_;
};

} // namespace planula
