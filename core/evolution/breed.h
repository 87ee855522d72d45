// SPDX-License-Identifier: MIT
// How one child is made: its parents, their crossover, its mutation, and the rules against clones and dead ends
// (§2.7.1; decision 0013).
#pragma once

#include "base/random.h"
#include "evolution/population.h"

#include <functional>
#include <span>

namespace planula {

/// The individuals that may become parents.
struct Parents {
    std::span<const Genome> genomes;  // in slot order
    std::span<const double> scores;   // in slot order; before any sharing, boost or penalty
    std::span<const Species> species; // none empty, each with its members by score, the highest first
};

/// Draws the slot of a parent.
using ParentDraw = std::function<int(Stream &)>;

/// The champion of a species, unchanged.
Genome copy_champion(const Parents &parents, const Species &species);

/// A child of this species, different from all its `siblings` if clone_tries tries can make it so. It has no id yet.
/// Innovations are recorded for rejected tries, too.
Genome breed(const Parents &parents, const Species &species, std::span<const Genome> siblings, bool recurrent,
             const NeatParameters &parameters, Innovations &innovations, Stream &stream);

/// The same for parents without species: each is drawn from all by `draw`.
Genome breed(const Parents &parents, const ParentDraw &draw, std::span<const Genome> siblings, bool recurrent,
             const NeatParameters &parameters, Innovations &innovations, Stream &stream);

} // namespace planula
