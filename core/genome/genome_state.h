// SPDX-License-Identifier: MIT
// Genomes of one run in saved state (base/state.h), column by column: numbers of one kind are together, which is what
// storage/packed.h shrinks most. Of each genome it is written where it comes from, which innovations it has and their
// weights. All else follows from the run's record of innovations: what a link joins; that a genome's hidden nodes are
// those at the ends of its links; and that a node is halfway between the ends of the link whose split made it. Genomes
// read back to the bit.
#pragma once

#include "base/state.h"
#include "genome/genome.h"
#include "genome/innovations.h"

#include <span>
#include <vector>

namespace planula {

/// All genomes have one shape and are made of these innovations, as evolution makes them.
void save(std::span<const Genome> genomes, const Innovations &innovations, StateWriter &writer);

/// Throws InputError unless whole genomes come next that are made of these innovations and sound (check_genome). The
/// record is that of a run of this shape: `inputs`, the bias included, and `outputs` together are its first_node().
std::vector<Genome> load_genomes(int inputs, int outputs, const Innovations &innovations,
                                 StateReader &reader);

} // namespace planula
