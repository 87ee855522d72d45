// SPDX-License-Identifier: MIT
// How a generation makes the next: the epoch of decision 0013 as MultiNEAT ran it (§2.7.1). Fitness is shared within
// species, species share the offspring, each breeds an unchanged copy of its champion first, and children choose their
// species by distance. Knows scores, not what they reward.
//
// All chance comes from one stream per child: (seed; new generation, order of birth, reproduction).
#pragma once

#include "evolution/population.h"

#include <cstdint>
#include <span>

namespace planula {

/// What a species' scores are multiplied by before offspring are shared out.
enum class Adjustment {
    none,   // nothing: a score is worth the same in every species
    age,    // boosts of young, penalties of old and stagnating species
    sharing // the same, over the size of the species
};

/// The next generation, of parameters.population genomes. `scores` are in slot order, finite, and at least 0.
/// `recurrent` is the shape's: it allows links that do not climb in depth.
Population reproduce(const Population &population, std::span<const double> scores, Adjustment adjustment,
                     bool recurrent, const NeatParameters &parameters, std::uint64_t seed);

} // namespace planula
