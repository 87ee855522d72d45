// SPDX-License-Identifier: MIT
// A genome's network in words: its nodes by the names of core/cell/channels.h, its links by what they feed.
#pragma once

#include "genome/genome.h"

#include <string>
#include <vector>

namespace planula {

/// "maternal east", "division angle", "hidden 21"; "input 3" where the genome is not that of an animat.
std::string name_of(const Genome &genome, const NodeGene &node);

/// The nodes that links may enter: outputs, then hidden nodes, the deepest first.
std::vector<NodeGene> fed_nodes(const Genome &genome);
/// The links that enter this node, the strongest first.
std::vector<LinkGene> links_into(const Genome &genome, int node);

/// Where the genome comes from, how large it is, and every link below the node that it enters.
std::string description_of(const Genome &genome);

/// The network in the language of Graphviz: ranks are depths, pen widths strengths, colours signs.
std::string dot_of(const Genome &genome);

} // namespace planula
