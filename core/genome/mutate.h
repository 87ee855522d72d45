// SPDX-License-Identifier: MIT
// The four mutation operators of NEAT and the draw among them (§2.7.1; decision 0013). A split link is deleted, not
// disabled; new structure takes its marking from the run's innovations. Networks are either acyclic, every link
// climbing in depth, or recurrent.
//
// Every operator keeps the invariants of check_genome, and leaves the genome untouched if it fails.
#pragma once

#include "base/random.h"
#include "genome/genome.h"
#include "genome/innovations.h"
#include "parameters/parameters.h"

namespace planula {

/// The weight of a link that nothing is known about: u± times its scale, within the limit.
double new_weight(double scale, const NeatParameters &parameters, Stream &stream);

/// Replaces all weights by new ones, or moves all of them, within the limit. Fails without links.
bool mutate_weights(const NeatParameters &parameters, Stream &stream, Genome &genome);

/// Splits a link that does not come from the bias: into the new node with weight 1, out of it with the old weight.
/// Fails if no such link is drawn. An acyclic network (not `recurrent`) also refuses a link whose ends are so close in
/// depth that there is no double between them.
bool add_node(const NeatParameters &parameters, bool recurrent, Innovations &innovations, Stream &stream,
              Genome &genome);

/// Joins two nodes that are not joined: upwards in depth or, in `recurrent` networks, level, downwards or to itself.
/// Fails if no such pair is drawn.
bool add_link(const NeatParameters &parameters, bool recurrent, Innovations &innovations, Stream &stream,
              Genome &genome);

/// Removes a link whose loss leaves no dead end. Fails if none is drawn.
bool remove_link(const NeatParameters &parameters, Stream &stream, Genome &genome);

/// Applies one operator, drawn by the weights of the parameters and drawn again as long as it fails. False, with the
/// genome untouched, if all draws fail.
bool mutate(const NeatParameters &parameters, bool recurrent, Innovations &innovations, Stream &stream,
            Genome &genome);

/// Whether the genome has dead ends: a hidden node without a way in (neither the bias nor a
/// self-loop is one) or out, an output with exactly one link in and one out (self-loops aside), or no link at all.
bool has_dead_ends(const Genome &genome);

} // namespace planula
