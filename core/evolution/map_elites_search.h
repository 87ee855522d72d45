// SPDX-License-Identifier: MIT
// MAP-Elites (Mouret & Clune 2015, "Illuminating search spaces by mapping elites", arXiv:1504.04909): the space of
// behaviours is divided into niches, and of all individuals that ever were in a niche the fittest is kept, the first of
// equals. Parents are drawn uniformly from these elites; a generation is a batch of children. The niches are the cubes
// of a grid without bounds, niche_width wide; a descriptor scales each of its numbers to that width. An invalid
// individual has no niche.
//
// An individual's score is what it adds to the map: its fitness less that of the elite it replaces, all of it in an
// empty niche, 0 if it replaces none. The sum of all that was ever added is the QD-score of Pugh, Soros & Stanley
// (2016), the sum of fitness over the map. The archive lists all individuals that became elites, with that score as
// novelty; the last entry of each niche holds it.
#pragma once

#include "evolution/brood.h"
#include "evolution/search.h"

#include <map>
#include <utility>

namespace planula {

class MapElitesSearch final : public Search {
  public:
    explicit MapElitesSearch(const Parameters &parameters)
        : MapElitesSearch(parameters.neat, parameters.map_elites.niche_width) {}

    /// Ranges of the descriptor, where they are stated, take the place of niche_width: the map is bounded, and what lies
    /// outside belongs to the niches at its edge (niche_of()).
    bool take(const Aims &aims) override;
    /// Throws InputError as check_behaviours() does.
    std::vector<double> score(const Population &population, std::span<const Evaluation> evaluations) override;
    /// As long as there is no elite, parents are drawn from the population.
    Population next(const Population &population, std::span<const double> scores, const NetworkShape &shape,
                    std::uint64_t seed) const override;
    std::span<const Genome> kept_genomes() const override { return elites_.genomes; }
    bool keeps_archive() const override { return true; }
    std::span<const ArchiveEntry> archive() const override { return archive_; }
    void save(const Population &population, StateWriter &writer) const override;
    void load(const Population &population, std::span<const ArchiveEntry> archive,
              StateReader &reader) override;

    /// One for each niche that was ever entered, in order of first entry.
    const Elites &elites() const { return elites_; }

  private:
    MapElitesSearch(const NeatParameters &neat, double niche_width)
        : neat_(neat), niche_width_(niche_width) {}

    /// Multiples of the width, rounded down; or numbers of niches in the ranges.
    using Niche = std::vector<double>;
    Niche niche_of(const Evaluation &evaluation) const;
    bool enters(const Evaluation &evaluation) const;
    /// Returns what it adds to the map.
    double enter(const Genome &genome, const Evaluation &evaluation);

    NeatParameters neat_;
    double niche_width_;
    std::vector<DescriptorNumber> ranges_; // empty without stated ranges
    Elites elites_;
    std::map<Niche, std::size_t> niches_; // places among the elites
    std::vector<ArchiveEntry> archive_;
    std::size_t length_ = 0; // of every behaviour of the run; 0 until the first is seen
};

} // namespace planula
