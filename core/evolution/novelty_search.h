// SPDX-License-Identifier: MIT
// Novelty search (Lehman & Stanley 2011; §2.7.2; MODEL section 7): an individual is rewarded for behaving
// unlike those that live and those in an archive of the past. ρ = mean Euclidean distance to the k nearest
// behaviours, Eq. (7). Fitness is never read; an invalid individual is as if it did not exist.
//
// The archive's threshold follows the pressure on it: a long unbroken run of additions raises it, a long time
// without any lowers it, never below its floor. The archive only grows.
#pragma once

#include "evolution/search.h"

#include <vector>

namespace planula {

class NoveltySearch final : public Search {
  public:
    explicit NoveltySearch(const Parameters &parameters)
        : parameters_(parameters), threshold_(parameters.archive_threshold) {}

    /// ρ × penalty; 0 for invalid individuals. Throws InputError if a valid individual has no behaviour, one
    /// that is not finite, or one of another length than the rest of the run.
    std::vector<double> score(const Population &population, std::span<const Evaluation> evaluations) override;
    Population next(const Population &population, std::span<const double> scores, const NetworkShape &shape,
                    std::uint64_t seed) const override;
    bool keeps_archive() const override { return true; }
    std::span<const ArchiveEntry> archive() const override { return archive_; }
    double archive_threshold() const override { return threshold_; }
    void save(StateWriter &writer) const override;
    void load(StateReader &reader) override;

  private:
    void check_behaviours(std::span<const Evaluation> evaluations);
    std::vector<double> novelties(std::span<const Evaluation> evaluations) const;
    void extend_archive(const Population &population, std::span<const Evaluation> evaluations,
                        std::span<const double> novelty);

    Parameters parameters_;
    std::vector<ArchiveEntry> archive_;
    double threshold_;
    std::size_t length_ = 0; // of every behaviour of the run; 0 until the first is seen
    int run_ = 0;            // additions since the last valid individual that was not added
    int quiet_ = 0;          // generations since the last addition or fall of the threshold
};

} // namespace planula
