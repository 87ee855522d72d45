// SPDX-License-Identifier: MIT
// A genome as rows of a table, and back to the same bits: first its origin and parents, then its nodes, then
// its links, each in the genome's own order. What comes from a file is refused unless check_genome accepts
// it.
#pragma once

#include "base/error.h"
#include "genome/genome.h"
#include "tables/csv.h"

#include <filesystem>
#include <span>
#include <vector>

namespace planula {

std::vector<GenomeRow> genome_rows(const Genome &genome);

/// Throws InputError naming the broken rule; the caller knows the file.
Genome genome_of(std::span<const GenomeRow> rows);

/// A genome among several, under the number of its generation.
struct NumberedGenome {
    int number;
    Genome genome;
};

/// Its rows, the number first.
template <class Row> std::vector<Row> numbered_rows(int number, const Genome &genome) {
    std::vector<Row> rows;
    for (const GenomeRow &row : genome_rows(genome))
        rows.push_back({number, row.kind, row.id, row.from, row.to, row.value, row.recurrent});
    return rows;
}

/// All genomes of such a table, by ascending number. Throws InputError that names file and line.
template <class Row> std::vector<NumberedGenome> read_numbered(const std::filesystem::path &folder) {
    std::vector<NumberedGenome> genomes;
    std::vector<GenomeRow> genes;
    int present = -1;
    TableReader<Row> reader(folder);
    const auto close = [&] {
        if (genes.empty()) return;
        try {
            genomes.push_back({present, genome_of(genes)});
        } catch (const InputError &error) {
            reader.refuse(error.what());
        }
        genes.clear();
    };
    for (Row row; reader.next(row);) {
        const auto &[number, kind, id, from, to, value, recurrent] = row;
        if (number < present) reader.refuse("this genome comes before the last one");
        if (number != present) close();
        present = number;
        genes.push_back({kind, id, from, to, value, recurrent});
    }
    close();
    return genomes;
}

} // namespace planula
