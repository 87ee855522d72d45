// SPDX-License-Identifier: MIT
// What mothers did, so that a generation can be compared with those who bred it. It is for records alone: no genome and
// no life depends on it.
//
// The mother of a child is the genome that it was made from, its first parent in a crossover. Only children that
// mutation or crossover made have one here: copies (champions, fillers, clones) and generation 0 have none. Of searches
// that breed from individuals kept over generations, a mother's life is her own, however long ago.
#pragma once

#include "base/state.h"
#include "evaluation/life.h"
#include "evolution/evaluation.h"
#include "evolution/population.h"

#include <cstdint>
#include <map>
#include <span>

namespace planula {

/// The results of an individual that is or may become a mother.
struct MotherLife {
    double fitness = 0; // Eq. 4, whatever the search rewards
    int cells = 0;      // at the end of development
    bool operator==(const MotherLife &) const = default;
};

class Mothers {
  public:
    /// The mother of a child that mutation or crossover made; null for others, and if she is not known.
    const MotherLife *of(const Genome &child) const;

    /// Everyone of a generation may become a mother. All three are in slot order.
    void add(const Population &population, std::span<const Life> lives,
             std::span<const Evaluation> evaluations);
    /// Forgets all but the mothers of this population and those whom the search keeps, all of whom are known.
    void keep(const Population &population, std::span<const Genome> kept);

    /// To be called after keep().
    void save(StateWriter &writer) const;
    /// Throws InputError unless the mothers of this population, and those kept by its search, come next.
    static Mothers load(const Population &population, std::span<const Genome> kept, StateReader &reader);

  private:
    std::map<std::int64_t, MotherLife> lives_; // by genome
};

} // namespace planula
