// SPDX-License-Identifier: MIT
#include "genome/genome_text.h"

#include "base/named_lines.h"

#include <array>

namespace planula {

namespace {

const std::array<std::string_view, 4> kinds{name_of(NodeKind::input), name_of(NodeKind::bias),
                                            name_of(NodeKind::output), name_of(NodeKind::hidden)};

void pass(Genome &genome, auto &lines) {
    lines.line("inputs", genome.inputs);
    lines.line("outputs", genome.outputs);
    lines.list("nodes", genome.nodes,
               [&](NodeGene &node) { lines.line("node", node.id, named(node.kind, kinds), node.depth); });
    lines.list("links", genome.links, [&](LinkGene &link) {
        lines.line("link", link.innovation, link.from, link.to, link.weight, link.recurrent);
    });
}

} // namespace

std::string write_genome(const Genome &genome) {
    Genome copy = genome;
    LineWriter lines;
    pass(copy, lines);
    return lines.text();
}

Genome read_genome(std::string_view text) {
    Genome genome;
    LineReader lines(text);
    pass(genome, lines);
    lines.done();
    check_genome(genome);
    return genome;
}

} // namespace planula
