// SPDX-License-Identifier: MIT
// Genomes to test with: by hand, and grown at random by the operators themselves.
#pragma once

#include "base/random.h"
#include "genome/genome.h"
#include "genome/innovations.h"
#include "genome/mutate.h"

#include <initializer_list>

namespace planula::specimens {

/// The stream of test number `n`.
inline Stream stream(std::uint32_t n, std::uint64_t seed = 1) {
    return Stream(seed, 0, n, Purpose::sampling);
}

/// Inputs (the last is the bias) and outputs, not linked.
inline Genome bare(int inputs, int outputs) {
    Genome genome;
    genome.inputs = inputs;
    genome.outputs = outputs;
    for (int id = 0; id < inputs + outputs; ++id) {
        const NodeKind kind = id < inputs - 1 ? NodeKind::input
                              : id < inputs   ? NodeKind::bias
                                              : NodeKind::output;
        genome.nodes.push_back({id, kind, kind == NodeKind::output ? 1.0 : 0.0});
    }
    return genome;
}

/// Every input linked to every output with weight 1.
inline Genome connected(int inputs, int outputs, Innovations &innovations) {
    Genome genome = bare(inputs, outputs);
    innovations = Innovations(inputs + outputs);
    for (int to = inputs; to < inputs + outputs; ++to)
        for (int from = 0; from < inputs; ++from)
            genome.links.push_back({innovations.link(from, to), from, to, 1, false});
    return genome;
}

/// A genome with these links, given as {innovation, weight}; link i joins input i to output 40.
inline Genome linked(std::initializer_list<std::pair<int, double>> links) {
    Genome genome = bare(40, 1);
    for (const auto &[innovation, weight] : links)
        genome.links.push_back({innovation, innovation, 40, weight, false});
    return genome;
}

/// The operators' rates with structure much favoured.
inline NeatParameters structural() {
    NeatParameters parameters;
    parameters.add_node_rate = 0.3;
    parameters.add_link_rate = 0.5;
    parameters.remove_link_rate = 0.1;
    parameters.mutate_weights_rate = 0.1;
    return parameters;
}

inline bool climbs(const Genome &genome) {
    for (const auto &link : genome.links)
        if (!(genome.find_node(link.from)->depth < genome.find_node(link.to)->depth)) return false;
    return true;
}

} // namespace planula::specimens
