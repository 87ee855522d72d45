// SPDX-License-Identifier: MIT
#include "analysis/lineage.h"

#include "analysis/history.h"
#include "base/error.h"
#include "base/text.h"
#include "genome/genome.h"

#include <algorithm>
#include <unordered_map>

namespace planula {

namespace {

LineageRow lineage_row(const IndividualRow &row) {
    return {.generation = row.generation,
            .slot = row.slot,
            .genome = row.genome,
            .origin = row.origin,
            .mother = row.mother,
            .father = row.father,
            .species = row.species,
            .fitness = row.fitness,
            .cells = row.cells,
            .links = row.links,
            .hidden = row.hidden};
}

bool is_copy(const LineageRow &row) {
    return row.origin == name_of(Origin::champion) || row.origin == name_of(Origin::filler) ||
           row.origin == name_of(Origin::clone);
}

} // namespace

std::vector<LineageRow> lineage(const RecordedRun &run, std::int64_t genome, bool with_copies) {
    // Only looked up by id, never walked.
    std::unordered_map<std::int64_t, LineageRow> individuals;
    each_individual(run, run.generations,
                    [&](const IndividualRow &row) { individuals.emplace(row.genome, lineage_row(row)); });
    const std::string file = (run.folder / IndividualRow::file_name).string();
    // A sample may lack any of them.
    const auto refuse_missing = [&](std::int64_t id, const std::string &otherwise) {
        if (run.record.full) throw InputError(file + ": " + otherwise);
        throw InputError(
            file + ": genome " + to_text(id) +
            " is not in the sample that the run has recorded; a lineage needs record = \"full\"");
    };
    auto at = individuals.find(genome);
    if (at == individuals.end()) refuse_missing(genome, "the run never had a genome " + to_text(genome));

    std::vector<LineageRow> line{at->second};
    for (std::int64_t mother = at->second.mother; mother != -1; mother = at->second.mother) {
        const std::int64_t child = at->first;
        at = individuals.find(mother);
        const std::string unborn =
            "genome " + to_text(child) + " has the mother " + to_text(mother) + ", who is not born before it";
        if (mother >= child) throw InputError(file + ": " + unborn);
        if (at == individuals.end()) refuse_missing(mother, unborn);
        if (with_copies || !is_copy(at->second)) line.push_back(at->second);
    }
    std::reverse(line.begin(), line.end());
    return line;
}

} // namespace planula
