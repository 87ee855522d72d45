// SPDX-License-Identifier: MIT
// Searches with several objectives, by the main loop of NSGA-II (Deb et al. 2002, §III.C; evolution/pareto.h): the
// individuals kept so far and the generation that was just evaluated are ranked together, by front and, within a front,
// by diversity. As many as a population holds are kept, and become parents by binary tournaments on that rank; they are
// not simulated again. Each search defines its objectives and its diversity.
//
// Novelty, Eq. (7), times the penalty, may be an objective. It is computed in every generation, for kept and new
// individuals, among all of both and the archive. The archive is that of novelty search; only new individuals
// enter it. An invalid individual is not feasible.
#pragma once

#include "evolution/brood.h"
#include "evolution/pareto.h"
#include "evolution/search.h"

#include <string>

namespace planula {

class ParetoSearch : public Search {
  public:
    /// Keeps the objectives that the experiment states.
    bool take(const Aims &aims) override;
    /// The number of individuals, kept or new, that an individual outranks. Throws InputError as check_behaviours()
    /// and check_objectives() do.
    std::vector<double> score(const Population &population, std::span<const Evaluation> evaluations) override;
    Population next(const Population &population, std::span<const double> scores, const NetworkShape &shape,
                    std::uint64_t seed) const override;
    std::span<const Genome> kept_genomes() const override { return kept_.genomes; }
    bool keeps_archive() const override { return true; }
    std::span<const ArchiveEntry> archive() const override { return archive_.entries(); }
    double archive_threshold() const override { return archive_.threshold(); }
    void save(const Population &population, StateWriter &writer) const override;
    void load(const Population &population, std::span<const ArchiveEntry> archive,
              StateReader &reader) override;

    /// The parents of the next generation, the highest rank first.
    const Elites &kept() const { return kept_; }

  protected:
    ParetoSearch(std::string name, const Parameters &parameters)
        : neat_(parameters.neat), name_(std::move(name)), archive_(parameters.novelty) {}

    using NeighbourLists = std::vector<std::vector<Neighbour>>;
    /// Of each valid individual of the pool, whose neighbours are those of NoveltyArchive::neighbours().
    virtual std::vector<Objectives> objectives(const Elites &pool, const NeighbourLists &neighbours,
                                               const NoveltyArchive &archive) const = 0;
    /// What decides within a front, the higher the better; there is at least one objective.
    virtual std::vector<double> diversity(std::span<const Objectives> objectives,
                                          std::span<const int> front) const = 0;

    const NeatParameters neat_;
    Aims aims_;

  private:
    std::vector<int> ranked(std::span<const Objectives> objectives) const;

    std::string name_;
    NoveltyArchive archive_;
    Elites kept_;
};

} // namespace planula
