// SPDX-License-Identifier: MIT
// The search seam: what is rewarded, and who breeds. A search turns the evaluations of a generation into
// scores, and makes the next generation: of that one alone, by NEAT's epoch (evolution/reproduce.h), or of
// individuals that it has kept (evolution/brood.h). Crossover and mutation are the same for all
// (evolution/breed.h).
#pragma once

#include "evolution/evaluation.h"
#include "evolution/novelty_archive.h"
#include "evolution/population.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

class Search {
  public:
    virtual ~Search() = default;

    /// One score per individual, in slot order; called once per generation, in order.
    virtual std::vector<double> score(const Population &population,
                                      std::span<const Evaluation> evaluations) = 0;
    /// The generation after this one, whose `scores` are those of the last call of score(). All chance comes
    /// from one stream per child: (seed; new generation, order of birth, reproduction).
    virtual Population next(const Population &population, std::span<const double> scores,
                            const NetworkShape &shape, std::uint64_t seed) const = 0;

    /// Those of earlier generations that may still have children.
    virtual std::span<const Genome> kept_genomes() const { return {}; }
    /// Whether the search has an archive.
    virtual bool keeps_archive() const { return false; }
    /// The archive so far, in order of entry; it only grows.
    virtual std::span<const ArchiveEntry> archive() const { return {}; }
    /// The novelty that the archive asks for at present; 0 for searches that ask for none.
    virtual double archive_threshold() const { return 0; }

    /// All that the search remembers but archive(), which grows too large to be saved again and again. `population` is
    /// the run's, to live next.
    virtual void save(const Population &population, StateWriter &writer) const = 0;
    /// Resumes where save() was called, in a search of the same name and parameters; `population` and `archive` are as
    /// they were there. Throws InputError, and must not be used any more, if the state is not sound.
    virtual void load(const Population &population, std::span<const ArchiveEntry> archive,
                      StateReader &reader) = 0;
};

/// The names that make_search knows: "neat", "novelty", "nsga2", "nslc" (local competition), "map-elites".
std::span<const std::string_view> search_names();
/// Throws InputError with the nearest name if there is no such search.
std::unique_ptr<Search> make_search(std::string_view name, const Parameters &parameters);

} // namespace planula
