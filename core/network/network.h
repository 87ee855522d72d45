// SPDX-License-Identifier: MIT
// The control network of one genome, constant, and how it moves the activations of many cells' copies of it (§2.1, 2.2;
// rules N3 to N5). Every node but the inputs computes tanh of the weighted sum of its sources; there is no node bias. A
// network depends neither on the meaning of its inputs nor on the owner of its activations.
#pragma once

#include "genome/genome.h"
#include "network/activations.h"

#include <vector>

namespace planula {

struct Network {
    int inputs = 0, outputs = 0; // nodes: inputs first (the bias last among them), then outputs, then hidden
    int nodes = 0;
    int depth = 0; // longest path from an input to an output, in links

    struct Source {
        int node;
        double weight;
    };
    std::vector<Source> sources;   // grouped by target, in order of innovation
    std::vector<int> first_source; // of target inputs + i; one more than there are targets
};

/// The network that a genome describes. `propagation_limit` caps the depth.
Network express(const Genome &genome, int propagation_limit);

/// One synchronous step in all cells: every link reads its source's old activation. The inputs must be set before.
/// Returns whether all activations but the inputs are finite then.
bool step(const Network &network, Activations &activations);

/// A stateless evaluation in all cells: all activations but the inputs cleared, then as many steps as the network is
/// deep. Returns as step().
bool evaluate(const Network &network, Activations &activations);

} // namespace planula
