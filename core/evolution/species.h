// SPDX-License-Identifier: MIT
// How children are placed in species (§2.7.1; decision 0013).
//
// A generation is born child by child with add_child() and ended by complete_generation(). In between, a genome's place
// is its order of birth, and each species is represented by a genome of the generation before, or by its founder.
#pragma once

#include "evolution/population.h"

namespace planula {

/// Gives the child an id and puts it into the first species, in list order, whose representative lies within the
/// population's threshold; if no species is, the child founds a species behind all others.
void add_child(const NeatParameters &parameters, Population &population, Genome child);

/// Ends the birth of a generation of `size`: species without members go, places left over are filled with copies of the
/// first species' first member, genomes move to slot order, and each species is represented by its first member. Needs
/// 1 … size children.
void complete_generation(int size, Population &population);

} // namespace planula
