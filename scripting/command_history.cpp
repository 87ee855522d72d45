// SPDX-License-Identifier: MIT
// Commands that read the record of one run: where it stands, who descends from whom, what a genome is.
#include "analysis/lineage.h"
#include "analysis/network_picture.h"
#include "analysis/network_text.h"
#include "base/error.h"
#include "base/text.h"
#include "record/csv.h"
#include "record/genome_table.h"
#include "record/output.h"
#include "record/run_reader.h"
#include "scripting/commands.h"

#include <algorithm>
#include <ostream>

namespace planula {

namespace {

constexpr Option genome_option{"genome", "ID|best",
                               "a champion of the run by its genome, or its best (default)"};

constexpr Option lineage_options[] = {
    {"genome", "ID|best", "any genome of the run, or its best (default)"},
    {"copies", "", "also ancestors that are unchanged copies of their mothers"},
};

constexpr Option genome_options[] = {
    genome_option,
    {"svg", "FILE", "draws the network into FILE"},
    {"dot", "FILE", "writes the network for Graphviz into FILE"},
};

/// The id that --genome asks for; nothing for the best.
std::optional<std::int64_t> asked_genome(const Arguments &arguments) {
    const std::string word = arguments.text("genome", "best");
    if (word == "best") return std::nullopt;
    const auto id = parse_int(word);
    if (!id || *id < 0) throw UsageError("--genome takes the number of a genome or best, not '" + word + "'");
    return id;
}

int print_lineage(const Arguments &arguments, Console &console) {
    const std::optional<std::int64_t> asked = asked_genome(arguments);
    const RecordedRun run = read_run(arguments.operands.at(0));
    const std::int64_t genome = asked ? *asked : read_best_genome(run).id;
    console.out << header_line<LineageRow>();
    for (const LineageRow &row : lineage(run, genome, arguments.has("copies"))) console.out << line_of(row);
    return 0;
}

/// The champion with this genome, or the last one.
NumberedGenome champion_of(const RecordedRun &run, std::optional<std::int64_t> id) {
    std::vector<NumberedGenome> champions = read_numbered<ChampionGenomeRow>(run.folder);
    const std::string file = (run.folder / ChampionGenomeRow::file_name).string();
    if (champions.empty()) throw InputError(file + ": there is no champion");
    if (!id) return champions.back();
    std::string known;
    for (const NumberedGenome &champion : champions) {
        if (champion.genome.id == *id) return champion;
        known.append(" ").append(to_text(champion.genome.id));
    }
    throw InputError(file + ": genome " + to_text(*id) +
                     " was never the run's best, so that only its row is kept; the champions are" + known);
}

int print_genome(const Arguments &arguments, Console &console) {
    const std::optional<std::int64_t> asked = asked_genome(arguments);
    const RecordedRun run = read_run(arguments.operands.at(0));
    const NumberedGenome champion = champion_of(run, asked);
    const std::string title = run.setting + ", seed " + to_text(run.seed) + ", generation " +
                              to_text(champion.number) + ", genome " + to_text(champion.genome.id);
    if (arguments.has("svg")) write_file(arguments.text("svg"), svg_of(champion.genome, title));
    if (arguments.has("dot")) write_file(arguments.text("dot"), dot_of(champion.genome));
    if (arguments.has("svg") || arguments.has("dot")) return 0;
    console.out << title << '\n' << description_of(champion.genome);
    return 0;
}

int print_status(const Arguments &arguments, Console &console) {
    std::size_t complete = 0;
    const std::vector<RunStatus> runs = statuses(arguments.operands.at(0));
    for (const RunStatus &run : runs) {
        complete += run.is_complete;
        console.out << run.folder.string() << ": "
                    << (run.is_complete       ? "complete, " + to_text(run.generations) + " generations"
                        : run.generations > 0 ? "generation " + to_text(run.done) + " of " +
                                                    to_text(run.generations) + " is kept"
                                              : std::string("nothing is kept"))
                    << '\n';
    }
    console.out << complete << " of " << runs.size() << " runs are complete\n";
    return 0;
}

} // namespace

const Command &lineage_command() {
    static const Command command{"lineage",
                                 "RUN",
                                 "prints who a run's best descends from, mother by mother, as a table",
                                 "RUN is the folder of a complete run. A CSV table, the oldest first; "
                                 "planula columns explains it under "
                                 "lineage.csv.",
                                 lineage_options,
                                 print_lineage};
    return command;
}

const Command &genome_command() {
    static const Command command{
        "genome",
        "RUN",
        "prints a champion's genome readably, or draws its network",
        "RUN is the folder of a complete run. Every individual that was fitter than all before it is a "
        "champion "
        "and has\nits genome kept. In the picture a link is the wider the stronger, blue if its weight is "
        "positive, red if negative.",
        genome_options,
        print_genome};
    return command;
}

const Command &status_command() {
    static const Command command{
        "status",
        "DIR",
        "tells how far the runs below a folder are",
        "DIR is what planula run was given as --out. One line for each run, and a count.",
        {},
        print_status};
    return command;
}

} // namespace planula
