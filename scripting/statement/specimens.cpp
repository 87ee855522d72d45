// SPDX-License-Identifier: MIT
#include "statement/specimens.h"

#include "base/error.h"
#include "experiment/spec.h"

namespace planula {

namespace {

bool is_gene(const ChampionGenomeRow &row) {
    return row.kind == "input" || row.kind == "bias" || row.kind == "output" || row.kind == "hidden" ||
           row.kind == "link";
}

/// All genomes of the file. A genome begins with a row that is no gene.
std::vector<Genome> read_all(const std::filesystem::path &file) {
    TableReader<ChampionGenomeRow> reader(file, header_of<ChampionGenomeRow>());
    std::vector<Genome> genomes;
    std::vector<GenomeRow> rows;
    const auto close = [&] {
        if (!rows.empty()) genomes.push_back(genome_of(rows));
        rows.clear();
    };
    for (ChampionGenomeRow row; reader.next(row);) {
        if (!is_gene(row)) close();
        rows.push_back({row.kind, row.id, row.from, row.to, row.value, row.recurrent});
    }
    close();
    return genomes;
}

} // namespace

std::vector<Genome> specimens(const std::filesystem::path &library, Actuation actuation) {
    const std::filesystem::path file = library / "specimens.csv";
    const NetworkShape shape = shape_of(actuation);
    std::vector<Genome> fitting;
    for (Genome &genome : read_all(file))
        if (genome.inputs == shape.inputs && genome.outputs == shape.outputs)
            fitting.push_back(std::move(genome));
    if (fitting.empty())
        throw InputError(file.string() + ": no genome fits the actuation '" + name_of(actuation) + "'");
    return fitting;
}

} // namespace planula
