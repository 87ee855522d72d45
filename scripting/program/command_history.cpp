// SPDX-License-Identifier: MIT
// Commands that read the record of one run: the ancestors of an individual, and its genome.
#include "analysis/lineage.h"
#include "analysis/network_picture.h"
#include "analysis/network_text.h"
#include "program/commands.h"
#include "program/individual.h"
#include "record/run_reader.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <optional>
#include <ostream>

namespace planula {

namespace {

constexpr Option lineage_options[] = {
    {"genome", "ID|best", "an individual by the number of its genome (default: best, the last champion)"},
    {"copies", "", "also print ancestors that are unchanged copies of their mothers"},
};

constexpr Option genome_options[] = {
    champion_option,
    generation_option,
    slot_option,
    threads_option,
    {"csv", "FILE", "write the genome to FILE, with the columns of genome.csv"},
    {"svg", "FILE", "draw the network to FILE"},
    {"dot", "FILE", "write the network to FILE, for Graphviz"},
};

/// The genome as a table with the columns of genome.csv.
std::string table_text(const Genome &genome) {
    std::string text = header_line<GenomeRow>();
    for (const GenomeRow &row : genome_rows(genome)) text += line_of(row);
    return text;
}

int print_lineage(const Arguments &arguments, Console &console) {
    const std::optional<std::int64_t> asked = asked_genome(arguments);
    const RecordedRun run = asked_run(arguments);
    const std::int64_t genome = asked ? *asked : read_champion_genome(run, run.generations).id;
    console.out << header_line<LineageRow>();
    for (const LineageRow &row : lineage(run, genome, arguments.has("copies"))) console.out << line_of(row);
    return 0;
}

int print_genome(const Arguments &arguments, Console &console) {
    const RecordedRun run = asked_run(arguments);
    const AskedIndividual shown = asked_individual(arguments, run);
    const std::string title = title_of(shown, run);
    if (arguments.has("svg")) write_new_file(arguments.text("svg"), svg_of(shown.genome, title));
    if (arguments.has("dot")) write_new_file(arguments.text("dot"), dot_of(shown.genome));
    if (arguments.has("csv")) write_new_file(arguments.text("csv"), table_text(shown.genome));
    if (arguments.has("svg") || arguments.has("dot") || arguments.has("csv")) return 0;
    console.out << title << '\n' << shown.life_text << '\n' << description_of(shown.genome);
    return 0;
}

} // namespace

const Command &lineage_command() {
    static const Command command{
        "lineage",
        "RUN",
        "prints the ancestors of an individual, mother by mother",
        R"(RUN is the folder of a complete run, or a folder with only one run below it. Prints a CSV table, the oldest ancestor first; planula columns explains it under
lineage.csv. Unchanged copies are left out: a mother without a line is a copy of the individual in the line above.)",
        lineage_options,
        print_lineage};
    return command;
}

const Command &genome_command() {
    static const Command command{
        "genome",
        "RUN",
        "prints the genome and the evaluation of an individual, or draws its network",
        R"(RUN is the folder of a complete run, or a folder with only one run below it. The genomes of champions, individuals that were fitter than all before them in the run,
are recorded. Any other individual is computed again, from the nearest saved state up to its generation; if that
generation differs from the record, the command ends with an error.

In the picture, wide links are strong, blue ones have a positive weight and red ones a negative one.)",
        genome_options,
        print_genome};
    return command;
}

} // namespace planula
