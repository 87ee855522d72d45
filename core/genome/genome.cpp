// SPDX-License-Identifier: MIT
#include "genome/genome.h"

#include "base/error.h"
#include "base/text.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace planula {

namespace {

[[noreturn]] void broken(const Genome &genome, const std::string &rule) {
    throw InputError("genome " + to_text(genome.id) + ": " + rule);
}

std::string name_of(const LinkGene &link) {
    return "link " + to_text(link.innovation) + " (" + to_text(link.from) + " to " + to_text(link.to) + ")";
}

/// What the node at this place must be: inputs, the bias, outputs, then hidden nodes.
NodeKind kind_at(const Genome &genome, int place) {
    if (place < genome.inputs - 1) return NodeKind::input;
    if (place < genome.inputs) return NodeKind::bias;
    return place < genome.inputs + genome.outputs ? NodeKind::output : NodeKind::hidden;
}

void check_node(const Genome &genome, int place) {
    const NodeGene &node = genome.nodes[place];
    const NodeKind kind = kind_at(genome, place);
    const std::string said = "node " + to_text(node.id);
    if (node.kind != kind)
        broken(genome, said + " is of kind " + name_of(node.kind) + " in the place of kind " + name_of(kind));
    if (kind != NodeKind::hidden && node.id != place)
        broken(genome, said + " is in the place of node " + to_text(place));
    if (place > 0 && node.id <= genome.nodes[place - 1].id)
        broken(genome, said + " does not follow node " + to_text(genome.nodes[place - 1].id));

    // Inputs have depth 0 and outputs depth 1; the comparison also refuses NaN.
    const double low = kind == NodeKind::output ? 1 : 0;
    const double high = kind == NodeKind::input || kind == NodeKind::bias ? 0 : 1;
    if (!(node.depth >= low && node.depth <= high))
        broken(genome, said + " of kind " + name_of(kind) + " has depth " + to_text(node.depth));
}

void check_link(const Genome &genome, const LinkGene &link) {
    if (!genome.find_node(link.from)) broken(genome, name_of(link) + " starts at a node that is not there");
    const NodeGene *target = genome.find_node(link.to);
    if (!target) broken(genome, name_of(link) + " ends at a node that is not there");
    if (target->kind == NodeKind::input || target->kind == NodeKind::bias)
        broken(genome, name_of(link) + " enters an input");
    if (!std::isfinite(link.weight))
        broken(genome, name_of(link) + " has the weight " + to_text(link.weight));
}

void check_order(const Genome &genome) {
    // Each link is newer than the one before it.
    int newest = -1;
    for (const auto &link : genome.links) {
        if (link.innovation <= newest)
            broken(genome, name_of(link) + " does not follow link " + to_text(newest));
        newest = link.innovation;
    }

    // No ordered pair of nodes is joined twice.
    std::vector<std::pair<int, int>> pairs;
    for (const auto &link : genome.links) pairs.emplace_back(link.from, link.to);
    std::sort(pairs.begin(), pairs.end());
    const auto twice = std::adjacent_find(pairs.begin(), pairs.end());
    if (twice != pairs.end())
        broken(genome, "two links join " + to_text(twice->first) + " to " + to_text(twice->second));
}

} // namespace

const NodeGene *Genome::find_node(int node_id) const {
    const auto found = std::lower_bound(nodes.begin(), nodes.end(), node_id,
                                        [](const NodeGene &node, int wanted) { return node.id < wanted; });
    return found != nodes.end() && found->id == node_id ? &*found : nullptr;
}

bool Genome::has_link(int from, int to) const {
    return std::any_of(links.begin(), links.end(),
                       [&](const LinkGene &link) { return link.from == from && link.to == to; });
}

void check_genome(const Genome &genome) {
    if (genome.inputs < 1 || genome.outputs < 1)
        broken(genome, "it has " + to_text(genome.inputs) + " inputs and " + to_text(genome.outputs) +
                           " outputs; at least one of each is needed");
    if (genome.nodes.size() < static_cast<std::size_t>(genome.inputs) + genome.outputs)
        broken(genome, "inputs or outputs are missing among its nodes");
    for (std::size_t place = 0; place < genome.nodes.size(); ++place)
        check_node(genome, static_cast<int>(place));
    check_order(genome);
    for (const auto &link : genome.links) check_link(genome, link);
}

std::vector<NodeGene> terminal_nodes(int inputs, int outputs) {
    const int bias = inputs - 1, ends = inputs + outputs;
    std::vector<NodeGene> nodes;
    for (int id = 0; id < bias; ++id) nodes.push_back({id, NodeKind::input, 0});
    nodes.push_back({bias, NodeKind::bias, 0});
    for (int id = inputs; id < ends; ++id) nodes.push_back({id, NodeKind::output, 1});
    return nodes;
}

std::vector<int> linked_nodes(int first, const std::vector<LinkGene> &links) {
    std::vector<int> linked;
    for (const auto &link : links)
        for (const int id : {link.from, link.to})
            if (id >= first) linked.push_back(id);
    std::sort(linked.begin(), linked.end());
    linked.erase(std::unique(linked.begin(), linked.end()), linked.end());
    return linked;
}

const char *name_of(Origin origin) {
    switch (origin) {
    case Origin::initial:
        return "initial";
    case Origin::champion:
        return "champion";
    case Origin::filler:
        return "filler";
    case Origin::clone:
        return "clone";
    case Origin::mutation:
        return "mutation";
    case Origin::crossover:
        return "crossover";
    case Origin::crossover_mutation:
        return "crossover_mutation";
    }
    return "unknown";
}

const char *name_of(NodeKind kind) {
    switch (kind) {
    case NodeKind::input:
        return "input";
    case NodeKind::bias:
        return "bias";
    case NodeKind::output:
        return "output";
    case NodeKind::hidden:
        return "hidden";
    }
    return "unknown";
}

} // namespace planula
