// SPDX-License-Identifier: MIT
#include "genome/genome_state.h"

#include "base/error.h"

#include <limits>

namespace planula {

namespace {

constexpr int largest = std::numeric_limits<int>::max();
constexpr std::size_t node_bytes = 3 * 8, link_bytes = 5 * 8;

NodeGene load_node(StateReader &reader) {
    NodeGene node;
    node.id = static_cast<int>(reader.integer(0, largest));
    node.kind = static_cast<NodeKind>(reader.integer(0, static_cast<int>(NodeKind::hidden)));
    node.depth = reader.finite();
    return node;
}

LinkGene load_link(StateReader &reader) {
    LinkGene link;
    link.innovation = static_cast<int>(reader.integer(0, largest));
    link.from = static_cast<int>(reader.integer(0, largest));
    link.to = static_cast<int>(reader.integer(0, largest));
    link.weight = reader.finite();
    link.recurrent = reader.integer(0, 1) == 1;
    return link;
}

} // namespace

void save(const Genome &genome, StateWriter &writer) {
    writer.group("genome").integer(genome.id).integer(genome.mother).integer(genome.father);
    writer.integer(static_cast<int>(genome.origin)).integer(genome.inputs).integer(genome.outputs);
    writer.integer(static_cast<std::int64_t>(genome.nodes.size()));
    for (const NodeGene &node : genome.nodes)
        writer.integer(node.id).integer(static_cast<int>(node.kind)).real(node.depth);
    writer.integer(static_cast<std::int64_t>(genome.links.size()));
    for (const LinkGene &link : genome.links) {
        writer.integer(link.innovation).integer(link.from).integer(link.to);
        writer.real(link.weight).integer(link.recurrent);
    }
}

Genome load_genome(StateReader &reader) {
    constexpr std::int64_t last_id = std::numeric_limits<std::int64_t>::max();
    Genome genome;
    reader.group("genome");
    genome.id = reader.integer(0, last_id);
    genome.mother = reader.integer(-1, last_id);
    genome.father = reader.integer(-1, last_id);
    genome.origin = static_cast<Origin>(reader.integer(0, static_cast<int>(Origin::crossover_mutation)));
    genome.inputs = static_cast<int>(reader.integer(1, largest));
    genome.outputs = static_cast<int>(reader.integer(1, largest));
    for (std::size_t left = reader.count(node_bytes); left > 0; --left)
        genome.nodes.push_back(load_node(reader));
    for (std::size_t left = reader.count(link_bytes); left > 0; --left)
        genome.links.push_back(load_link(reader));
    try {
        check_genome(genome);
    } catch (const InputError &error) {
        reader.refuse(error.what());
    }
    return genome;
}

} // namespace planula
