// SPDX-License-Identifier: MIT
#include "analysis/network_text.h"

#include "base/text.h"
#include "cell/channels.h"

#include <algorithm>
#include <cmath>

namespace planula {

namespace {

/// The channel's name, if the genome is that of an animat.
std::string channel_name(const Genome &genome, const NodeGene &node) {
    if (genome.inputs != input::count) return "";
    if (node.id < genome.inputs) return input::names.at(static_cast<std::size_t>(node.id));
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        if (genome.outputs == output::count(actuation))
            return output::name_of(actuation, node.id - genome.inputs);
    return "";
}

std::string padded(std::string text, std::size_t width) {
    return text.size() < width ? text + std::string(width - text.size(), ' ') : text;
}

/// "mutation of 12", "crossover of 12 and 15", "initial".
std::string origin_of(const Genome &genome) {
    std::string text = name_of(genome.origin);
    if (genome.mother >= 0) text += " of " + to_text(genome.mother);
    if (genome.father >= 0) text += " and " + to_text(genome.father);
    return text;
}

} // namespace

std::string name_of(const Genome &genome, const NodeGene &node) {
    const bool is_hidden = node.kind == NodeKind::hidden;
    const std::string channel = is_hidden ? "" : channel_name(genome, node);
    if (!channel.empty()) return channel;
    const int number = node.kind == NodeKind::output ? node.id - genome.inputs : node.id;
    return std::string(name_of(node.kind)) + " " + to_text(number);
}

std::vector<NodeGene> fed_nodes(const Genome &genome) {
    const auto outputs = genome.nodes.begin() + genome.inputs, hidden = outputs + genome.outputs;
    std::vector<NodeGene> nodes(outputs, genome.nodes.end());
    std::stable_sort(nodes.begin() + (hidden - outputs), nodes.end(),
                     [](const NodeGene &a, const NodeGene &b) { return a.depth > b.depth; });
    return nodes;
}

std::vector<LinkGene> links_into(const Genome &genome, int node) {
    std::vector<LinkGene> links;
    std::copy_if(genome.links.begin(), genome.links.end(), std::back_inserter(links),
                 [&](const LinkGene &link) { return link.to == node; });
    std::stable_sort(links.begin(), links.end(), [](const LinkGene &a, const LinkGene &b) {
        return std::abs(a.weight) > std::abs(b.weight);
    });
    return links;
}

std::string description_of(const Genome &genome) {
    constexpr std::size_t name_width = 22;
    constexpr int decimals = 3;
    std::string text = "genome " + to_text(genome.id) + ", " + origin_of(genome) + "\n" +
                       counted(genome.inputs, "input") + ", " + counted(genome.outputs, "output") + ", " +
                       counted(genome.hidden(), "hidden node") + ", " + counted(genome.links.size(), "link") +
                       "\n";
    for (const NodeGene &node : fed_nodes(genome)) {
        text.append("\n").append(name_of(genome, node));
        if (node.kind == NodeKind::hidden) text += ", depth " + to_text(node.depth);
        text += "\n";
        for (const LinkGene &link : links_into(genome, node.id)) {
            const std::string weight = to_fixed(link.weight, decimals);
            text += "  " + padded(name_of(genome, *genome.find_node(link.from)), name_width) +
                    (link.weight < 0 ? "" : " ") + weight + (link.recurrent ? "  recurrent" : "") + "\n";
        }
    }
    return text;
}

std::string dot_of(const Genome &genome) {
    std::string text = "digraph genome_" + to_text(genome.id) + " {\n  rankdir=LR;\n  node [shape=box];\n";
    for (const NodeKind kind : {NodeKind::input, NodeKind::output, NodeKind::hidden}) {
        // Inputs, the bias among them, stand on the left, outputs on the right.
        const char *rank = kind == NodeKind::input ? "source" : kind == NodeKind::output ? "sink" : nullptr;
        text += rank ? "  { rank=" + std::string(rank) + ";" : "  {";
        for (const NodeGene &node : genome.nodes) {
            const bool belongs =
                node.kind == kind || (kind == NodeKind::input && node.kind == NodeKind::bias);
            if (belongs) text += " n" + to_text(node.id) + " [label=\"" + name_of(genome, node) + "\"];";
        }
        text += " }\n";
    }
    for (const LinkGene &link : genome.links)
        text += "  n" + to_text(link.from) + " -> n" + to_text(link.to) +
                " [penwidth=" + to_fixed(0.5 + std::min(std::abs(link.weight), 10.0) / 2, 2) +
                ", color=" + (link.weight < 0 ? "red" : "blue") + (link.recurrent ? ", style=dashed" : "") +
                ", tooltip=\"" + to_text(link.weight) + "\"];\n";
    return text + "}\n";
}

} // namespace planula
