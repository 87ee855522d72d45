// SPDX-License-Identifier: MIT
// The genome of NEAT (Stanley & Miikkulainen 2002) as MultiNEAT kept it in 2013: a list of nodes and a list of links,
// each with its historical marking. §2.7; decisions 0005 and 0013. A genome has no information about cells or bodies.
//
// Invariants (check_genome): nodes ascend by id: inputs 0 … inputs-1 (the bias is the last), then outputs, then hidden
// nodes; links ascend by innovation, and no two join the same ordered pair; every end of a link is a node; no link
// enters an input. Node ids and innovations mean the same split or link in a whole run. In a genome made without
// recurrence every link climbs in depth, so that the network is acyclic.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace planula {

enum class NodeKind : std::uint8_t { input, bias, output, hidden };

struct NodeGene {
    int id = 0;
    NodeKind kind = NodeKind::hidden;
    double depth = 0; // SplitY: inputs 0, outputs 1, a split node the mean of its link's ends
    bool operator==(const NodeGene &) const = default;
};

struct LinkGene {
    int innovation = 0;
    int from = 0, to = 0; // node ids
    double weight = 0;
    bool recurrent = false;
    bool operator==(const LinkGene &) const = default;
};

/// The operator that made a genome and the ids of its parents (-1 where there is no parent).
enum class Origin : std::uint8_t {
    initial,
    champion,
    filler,
    clone,
    mutation,
    crossover,
    crossover_mutation
};

struct Genome {
    std::int64_t id = 0; // unique in a run, in order of birth
    std::int64_t mother = -1, father = -1;
    Origin origin = Origin::initial;
    int inputs = 0, outputs = 0; // inputs include the bias
    std::vector<NodeGene> nodes;
    std::vector<LinkGene> links;

    int hidden() const { return static_cast<int>(nodes.size()) - inputs - outputs; }
    const NodeGene *find_node(int node_id) const;
    bool has_link(int from, int to) const;
    bool operator==(const Genome &) const = default;
};

/// Throws InputError naming the first broken invariant, a weight that is not finite included.
void check_genome(const Genome &genome);

/// Inputs, the bias and outputs, in the order of a genome's nodes.
std::vector<NodeGene> terminal_nodes(int inputs, int outputs);
/// The ids of all nodes from `first` on at the ends of these links, ascending.
std::vector<int> linked_nodes(int first, const std::vector<LinkGene> &links);

const char *name_of(Origin origin);
const char *name_of(NodeKind kind);

} // namespace planula
