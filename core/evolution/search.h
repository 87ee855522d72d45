// SPDX-License-Identifier: MIT
// The search seam: what a population is rewarded for. A search turns evaluations into scores; speciation,
// mating and mutation are the same for all (evolution/reproduce.h).
#pragma once

#include "base/state.h"
#include "evolution/evaluation.h"
#include "evolution/population.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// An individual in the archive of novelty search.
struct ArchiveEntry {
    int generation = 0;
    std::int64_t genome = 0; // id
    std::vector<double> behaviour;
    double novelty = 0; // when it was added
};

class Search {
  public:
    virtual ~Search() = default;

    /// One score per individual, in slot order; called once per generation, in order.
    virtual std::vector<double> score(const Population &population,
                                      std::span<const Evaluation> evaluations) = 0;
    /// Whether scores are shared within species, with boosts for young and penalties for stagnating species.
    virtual bool shares_fitness() const = 0;
    /// The archive so far; empty for searches without one.
    virtual std::span<const ArchiveEntry> archive() const { return {}; }
    /// The archive's present threshold; 0 for searches without one.
    virtual double archive_threshold() const { return 0; }

    /// All that score() remembers of earlier generations.
    virtual void save(StateWriter &writer) const = 0;
    /// Goes on where save() was called, in a search of the same name and parameters. Throws InputError, and
    /// must not be used any more, if the state is not sound.
    virtual void load(StateReader &reader) = 0;
};

/// The names that make_search knows: "neat", "novelty".
std::span<const std::string_view> search_names();
/// Throws InputError with the nearest name if there is no such search.
std::unique_ptr<Search> make_search(std::string_view name, const Parameters &parameters);

} // namespace planula
