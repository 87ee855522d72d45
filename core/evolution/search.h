// SPDX-License-Identifier: MIT
// The interface of all searches: what is rewarded, and who has offspring. A search turns the evaluations of a
// generation into scores and makes the next generation, either from that one alone, by NEAT's epoch
// (evolution/reproduce.h), or from individuals that it has kept (evolution/brood.h). Crossover and mutation are the
// same for all (evolution/breed.h).
//
// A new search is one file, <name>_search.cpp, and its line in evolution/searches.inl.
#pragma once

#include "evolution/aims.h"
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

    /// To be called before anything else, if at all. False if this search reads no objectives and some are stated;
    /// throws InputError for aims that it cannot have.
    virtual bool take(const Aims &aims) { return aims.objectives.empty(); }

    /// One score per individual, in slot order; called once per generation, in order.
    virtual std::vector<double> score(const Population &population,
                                      std::span<const Evaluation> evaluations) = 0;
    /// The generation after this one, whose `scores` are those of the last call of score(). All chance comes from one
    /// stream per child: (seed; new generation, order of birth, reproduction).
    virtual Population next(const Population &population, std::span<const double> scores,
                            const NetworkShape &shape, std::uint64_t seed) const = 0;

    /// The individuals of earlier generations that may still have children.
    virtual std::span<const Genome> kept_genomes() const { return {}; }
    /// Whether the search has an archive.
    virtual bool keeps_archive() const { return false; }
    /// The archive so far, in order of entry; it only grows.
    virtual std::span<const ArchiveEntry> archive() const { return {}; }
    /// The novelty that is needed to enter the archive now; 0 for searches without such a threshold.
    virtual double archive_threshold() const { return 0; }

    /// All that the search remembers except archive(), which grows too large to be saved each time. `population` is the
    /// run's, to be evaluated next.
    virtual void save(const Population &population, StateWriter &writer) const = 0;
    /// Resumes where save() was called, in a search of the same name and parameters; `population` and `archive` are as
    /// they were there. Throws InputError, and must not be used any more, if the state is not sound.
    virtual void load(const Population &population, std::span<const ArchiveEntry> archive,
                      StateReader &reader) = 0;
};

/// A line of evolution/searches.inl.
struct SearchRow {
    std::string_view name, score; // score: what the search rewards
    std::unique_ptr<Search> (*make)(const Parameters &parameters);
};

std::span<const SearchRow> search_rows();
std::vector<std::string_view> search_names();
/// What each search rewards: "neat: fitness; novelty: …".
std::string search_scores();
/// Throws InputError with the nearest name if there is no such search, and if it cannot have these aims.
std::unique_ptr<Search> make_search(std::string_view name, const Parameters &parameters,
                                    const Aims &aims = {});

} // namespace planula
