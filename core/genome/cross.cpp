// SPDX-License-Identifier: MIT
#include "genome/cross.h"

#include "base/check.h"
#include "genome/align.h"
#include "genome/weight.h"

#include <vector>

namespace planula {

namespace {

Side fitter(const Parent &mother, const Parent &father, Stream &stream) {
    if (mother.score != father.score) return mother.score > father.score ? Side::first : Side::second;
    const std::size_t of_mother = mother.genome.links.size(), of_father = father.genome.links.size();
    if (of_mother != of_father) return of_mother < of_father ? Side::first : Side::second;
    return stream.chance(0.5) ? Side::first : Side::second;
}

/// The matching link that the child gets; an averaged one has the mother's recurrent flag.
LinkGene inherit(const LinkGene &of_mother, const LinkGene &of_father, const Crossing &crossing,
                 Stream &stream) {
    if (!crossing.averaging) return stream.chance(0.5) ? of_mother : of_father;
    LinkGene link = of_mother;
    link.weight = rounded_weight((of_mother.weight + of_father.weight) / 2, crossing.weight_step);
    return link;
}

/// Inputs, outputs and the hidden nodes at the ends of links, in ascending order of id. A node has the same depth in
/// all genomes of a run, so either parent's will do.
std::vector<NodeGene> needed_nodes(const Genome &mother, const Genome &father,
                                   const std::vector<LinkGene> &links) {
    const int ends = mother.inputs + mother.outputs;
    std::vector<NodeGene> nodes(mother.nodes.begin(), mother.nodes.begin() + ends);
    for (const int id : linked_nodes(ends, links)) {
        const NodeGene *node = mother.find_node(id);
        nodes.push_back(node ? *node : *father.find_node(id));
    }
    return nodes;
}

} // namespace

Genome cross(const Parent &mother, const Parent &father, const Crossing &crossing, Stream &stream) {
    CHECK(mother.genome.inputs == father.genome.inputs && mother.genome.outputs == father.genome.outputs);
    Genome child;
    child.mother = mother.genome.id;
    child.father = father.genome.id;
    child.origin = Origin::crossover;
    child.inputs = mother.genome.inputs;
    child.outputs = mother.genome.outputs;

    const Side better = fitter(mother, father, stream);
    align(
        mother.genome, father.genome,
        [&](const LinkGene &of_mother, const LinkGene &of_father) {
            child.links.push_back(inherit(of_mother, of_father, crossing, stream));
        },
        [&](const LinkGene &link, Side side, bool) {
            if (side == better || crossing.interspecies) child.links.push_back(link);
        });
    child.nodes = needed_nodes(mother.genome, father.genome, child.links);
    return child;
}

} // namespace planula
