// SPDX-License-Identifier: MIT
#include "genome/mutate.h"

#include "genome/weight.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace planula {

namespace {

/// The weight that a genome gets in place of this one.
double clamped(double weight, const NeatParameters &parameters) {
    return std::clamp(rounded_weight(weight, parameters.weight_step), -parameters.weight_limit,
                      parameters.weight_limit);
}

std::uint32_t count_of(const auto &container) { return static_cast<std::uint32_t>(container.size()); }

/// A node drawn uniformly from those at place `first` and later.
const NodeGene &draw_node(const Genome &genome, int first, Stream &stream) {
    return genome.nodes[first + stream.below(count_of(genome.nodes) - first)];
}

void insert(Genome &genome, const NodeGene &node) {
    const auto place = std::find_if(genome.nodes.begin(), genome.nodes.end(),
                                    [&](const NodeGene &other) { return other.id > node.id; });
    genome.nodes.insert(place, node);
}

void insert(Genome &genome, const LinkGene &link) {
    const auto place = std::find_if(genome.links.begin(), genome.links.end(), [&](const LinkGene &other) {
        return other.innovation > link.innovation;
    });
    genome.links.insert(place, link);
}

/// The node that splits this link: the first on record that the genome does not have, else a new one.
int split_node(const Genome &genome, const LinkGene &link, Innovations &innovations) {
    for (const int known : innovations.splits(link.from, link.to))
        if (!genome.find_node(known)) return known;
    return innovations.new_split(link.from, link.to);
}

/// The depth of a node that would split this link; nothing if the link is not to be split.
std::optional<double> split_depth(const Genome &genome, const LinkGene &link, bool recurrent) {
    const NodeGene &from = *genome.find_node(link.from), &to = *genome.find_node(link.to);
    if (from.kind == NodeKind::bias) return {};
    const double depth = (from.depth + to.depth) / 2;
    if (!recurrent && !(from.depth < depth && depth < to.depth)) return {};
    return depth;
}

enum class Direction { forward, backward, loop };

Direction draw_direction(const NeatParameters &parameters, bool recurrent, Stream &stream) {
    if (!recurrent || !stream.chance(parameters.recurrent_rate)) return Direction::forward;
    return stream.chance(parameters.loop_rate) ? Direction::loop : Direction::backward;
}

/// Links out of outputs count as backward; level links are forward, and would close cycles in an acyclic network.
bool may_join(const NodeGene &from, const NodeGene &to, Direction direction, bool recurrent) {
    if (direction == Direction::loop) return true;
    if (direction == Direction::backward) return from.depth > to.depth;
    return from.id != to.id && from.kind != NodeKind::output &&
           (recurrent ? from.depth <= to.depth : from.depth < to.depth);
}

/// The links that count for dead ends, at each place in the genome's list of nodes.
struct Degree {
    int in = 0, in_not_from_bias = 0, out = 0;
};

std::vector<Degree> count_degrees(const Genome &genome) {
    std::vector<Degree> degrees(genome.nodes.size());
    const auto degree = [&](const NodeGene *node) -> Degree & { return degrees[node - genome.nodes.data()]; };
    for (const auto &link : genome.links) {
        if (link.from == link.to) continue;
        const NodeGene *from = genome.find_node(link.from), *to = genome.find_node(link.to);
        ++degree(from).out, ++degree(to).in;
        if (from->kind != NodeKind::bias) ++degree(to).in_not_from_bias;
    }
    return degrees;
}

} // namespace

double new_weight(double scale, const NeatParameters &parameters, Stream &stream) {
    return clamped(scale * stream.triangular(), parameters);
}

bool mutate_weights(const NeatParameters &parameters, Stream &stream, Genome &genome) {
    if (genome.links.empty()) return false;
    const bool severe = stream.chance(parameters.weight_severe_rate);
    for (auto &link : genome.links)
        link.weight = severe
                          ? new_weight(parameters.weight_replacement, parameters, stream)
                          : clamped(link.weight + parameters.weight_power * stream.triangular(), parameters);
    return true;
}

bool add_node(const NeatParameters &parameters, bool recurrent, Innovations &innovations, Stream &stream,
              Genome &genome) {
    if (genome.links.empty()) return false;
    for (int tries = 0; tries < parameters.split_tries; ++tries) {
        const std::uint32_t place = stream.below(count_of(genome.links));
        const LinkGene split = genome.links[place];
        const auto depth = split_depth(genome, split, recurrent);
        if (!depth) continue;

        // The node and its two links take the place of the link.
        const int node = split_node(genome, split, innovations);
        const int in = innovations.link(split.from, node);
        const int out = innovations.link(node, split.to);
        genome.links.erase(genome.links.begin() + place);
        insert(genome, NodeGene{node, NodeKind::hidden, *depth});
        insert(genome, LinkGene{in, split.from, node, 1, split.recurrent});
        insert(genome, LinkGene{out, node, split.to, split.weight, split.recurrent});
        return true;
    }
    return false;
}

bool add_link(const NeatParameters &parameters, bool recurrent, Innovations &innovations, Stream &stream,
              Genome &genome) {
    const Direction direction = draw_direction(parameters, recurrent, stream);
    for (int tries = 0; tries < parameters.link_tries; ++tries) {
        // Any node starts a forward link; none enters an input.
        const NodeGene &from = draw_node(genome, direction == Direction::forward ? 0 : genome.inputs, stream);
        const NodeGene &to = direction == Direction::loop ? from : draw_node(genome, genome.inputs, stream);
        if (!may_join(from, to, direction, recurrent) || genome.has_link(from.id, to.id)) continue;

        const int innovation = innovations.link(from.id, to.id);
        const double weight = new_weight(parameters.weight_replacement, parameters, stream);
        insert(genome, LinkGene{innovation, from.id, to.id, weight, direction != Direction::forward});
        return true;
    }
    return false;
}

bool remove_link(const NeatParameters &parameters, Stream &stream, Genome &genome) {
    if (genome.links.empty()) return false;
    for (int tries = 0; tries < parameters.link_tries; ++tries) {
        // The newest link is never drawn (MN).
        const auto place = static_cast<std::ptrdiff_t>(
            std::floor(stream.uniform() * static_cast<double>(genome.links.size() - 1)));
        const LinkGene removed = genome.links[place];
        genome.links.erase(genome.links.begin() + place);
        if (!has_dead_ends(genome)) return true;
        genome.links.insert(genome.links.begin() + place, removed);
    }
    return false;
}

bool mutate(const NeatParameters &parameters, bool recurrent, Innovations &innovations, Stream &stream,
            Genome &genome) {
    // The operators share the range 0 … end of the draw in proportion to their weights.
    const double node_end = parameters.add_node_rate;
    const double link_end = node_end + parameters.add_link_rate;
    const double removal_end = link_end + parameters.remove_link_rate;
    const double end = removal_end + parameters.mutate_weights_rate;
    for (int tries = 0; tries < parameters.operator_tries; ++tries) {
        const double draw = end * stream.uniform();
        const bool done = draw < node_end      ? add_node(parameters, recurrent, innovations, stream, genome)
                          : draw < link_end    ? add_link(parameters, recurrent, innovations, stream, genome)
                          : draw < removal_end ? remove_link(parameters, stream, genome)
                                               : mutate_weights(parameters, stream, genome);
        if (done) return true;
    }
    return false;
}

bool has_dead_ends(const Genome &genome) {
    if (genome.links.empty()) return true;
    const std::vector<Degree> degrees = count_degrees(genome);
    for (std::size_t place = genome.inputs; place < genome.nodes.size(); ++place) {
        const Degree &degree = degrees[place];
        const bool leads_nowhere = genome.nodes[place].kind == NodeKind::output
                                       ? degree.in == 1 && degree.out == 1
                                       : degree.in_not_from_bias == 0 || degree.out == 0;
        if (leads_nowhere) return true;
    }
    return false;
}

} // namespace planula
