// SPDX-License-Identifier: MIT
#include "tables/genome_table.h"

#include "base/error.h"
#include "base/text.h"
#include "tables/csv.h"

#include <array>
#include <limits>

namespace planula {

namespace {

constexpr std::array origins{
    Origin::initial,   Origin::champion,          Origin::filler, Origin::clone, Origin::mutation,
    Origin::crossover, Origin::crossover_mutation};
constexpr std::array kinds{NodeKind::input, NodeKind::bias, NodeKind::output, NodeKind::hidden};

[[noreturn]] void refuse(const GenomeRow &row, const std::string &what) {
    throw InputError("genome row '" + row.kind + "' with id " + to_text(row.id) + ": " + what);
}

/// A number of a node or link.
int number_of(const GenomeRow &row, MaybeId value, const char *column) {
    if (!value) refuse(row, std::string("the column '") + column + "' is empty");
    if (*value < 0 || *value > std::numeric_limits<int>::max())
        refuse(row,
               std::string("'") + column + "' = " + to_text(*value) + " is not a number of a node or link");
    return static_cast<int>(*value);
}

double value_of(const GenomeRow &row) {
    if (!row.value) refuse(row, "the column 'value' is empty");
    return *row.value;
}

void read_head(const GenomeRow &row, Genome &genome) {
    for (const Origin origin : origins) {
        if (row.kind != name_of(origin)) continue;
        if (!row.from || !row.to) refuse(row, "the parents are missing");
        genome.id = row.id, genome.mother = *row.from, genome.father = *row.to, genome.origin = origin;
        return;
    }
    refuse(row, "a genome starts with its origin");
}

LinkGene read_link(const GenomeRow &row) {
    if (row.recurrent != 0 && row.recurrent != 1) refuse(row, "'recurrent' is neither 0 nor 1");
    return {number_of(row, row.id, "id"), number_of(row, row.from, "from"), number_of(row, row.to, "to"),
            value_of(row), row.recurrent == 1};
}

void read_node(const GenomeRow &row, Genome &genome) {
    if (!genome.links.empty()) refuse(row, "a node follows a link");
    for (const NodeKind kind : kinds) {
        if (row.kind != name_of(kind)) continue;
        genome.nodes.push_back({number_of(row, row.id, "id"), kind, value_of(row)});
        genome.inputs += kind == NodeKind::input || kind == NodeKind::bias;
        genome.outputs += kind == NodeKind::output;
        return;
    }
    refuse(row, "neither a kind of node nor a link");
}

} // namespace

std::vector<GenomeRow> genome_rows(const Genome &genome) {
    std::vector<GenomeRow> rows{
        {name_of(genome.origin), genome.id, genome.mother, genome.father, std::nullopt, 0}};
    for (const NodeGene &node : genome.nodes)
        rows.push_back({name_of(node.kind), node.id, std::nullopt, std::nullopt, node.depth, 0});
    for (const LinkGene &link : genome.links)
        rows.push_back({"link", link.innovation, link.from, link.to, link.weight, link.recurrent ? 1 : 0});
    return rows;
}

Genome genome_of(std::span<const GenomeRow> rows) {
    if (rows.empty()) throw InputError("a genome without rows");
    Genome genome;
    read_head(rows.front(), genome);
    for (const GenomeRow &row : rows.subspan(1)) {
        if (row.kind == "link")
            genome.links.push_back(read_link(row));
        else
            read_node(row, genome);
    }
    check_genome(genome);
    return genome;
}

} // namespace planula
