// SPDX-License-Identifier: MIT
// Commands that read the record of one run: the ancestors of an individual, and its genome.
#include "analysis/history.h"
#include "analysis/lineage.h"
#include "analysis/network_picture.h"
#include "analysis/network_text.h"
#include "analysis/replay.h"
#include "base/error.h"
#include "base/text.h"
#include "program/commands.h"
#include "program/interrupt.h"
#include "record/run_reader.h"
#include "storage/output.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <optional>
#include <ostream>

namespace planula {

namespace {

constexpr Option genome_option{"genome", "ID|best",
                               "a champion by the number of its genome (default: best, the last champion)"};

constexpr Option lineage_options[] = {
    {"genome", "ID|best", "an individual by the number of its genome (default: best, the last champion)"},
    {"copies", "", "also print ancestors that are unchanged copies of their mothers"},
};

constexpr Option genome_options[] = {
    genome_option,
    {"generation", "G", "with --slot: any individual of the run, by its generation, from 0"},
    {"slot", "S", "the place of the individual in its generation, from 0"},
    threads_option,
    {"csv", "FILE", "write the genome to FILE, with the columns of genome.csv"},
    {"svg", "FILE", "draw the network to FILE"},
    {"dot", "FILE", "write the network to FILE, for Graphviz"},
};

/// The id that --genome asks for; nothing for the best.
std::optional<std::int64_t> asked_genome(const Arguments &arguments) {
    const std::string word = arguments.text("genome", "best");
    if (word == "best") return std::nullopt;
    const auto id = parse_int(word);
    if (!id || *id < 0)
        throw UsageError("--genome takes the number of a genome, or best, not '" + word + "'");
    return id;
}

/// Writes a file that the user named. Anything there that is not a regular file, such as a device, is not replaced.
void write_new_file(const std::filesystem::path &path, const std::string &text) {
    if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
        throw CreateError(path.string() + " exists and is not a file; it is not replaced");
    write_file(path, text);
}

/// The genome as a table with the columns of genome.csv.
std::string table_text(const Genome &genome) {
    std::string text = header_line<GenomeRow>();
    for (const GenomeRow &row : genome_rows(genome)) text += line_of(row);
    return text;
}

int print_lineage(const Arguments &arguments, Console &console) {
    const std::optional<std::int64_t> asked = asked_genome(arguments);
    const RecordedRun run = read_run(arguments.operands.at(0));
    const std::int64_t genome = asked ? *asked : read_champion_genome(run, run.generations).id;
    console.out << header_line<LineageRow>();
    for (const LineageRow &row : lineage(run, genome, arguments.has("copies"))) console.out << line_of(row);
    return 0;
}

/// An individual of a run, and its evaluation in words.
struct Shown {
    int generation = 0;
    Genome genome;
    std::string life;
};

/// The champion with this genome, or the last one, as the run has recorded it.
Shown champion_of(const RecordedRun &run, std::optional<std::int64_t> id) {
    std::vector<NumberedGenome> champions = read_numbered<ChampionGenomeRow>(run.folder);
    const std::string file = (run.folder / ChampionGenomeRow::file_name).string();
    if (champions.empty()) throw InputError(file + ": the run has no champion: no individual was valid");
    std::string known;
    for (std::size_t i = 0; i < champions.size(); ++i) {
        const NumberedGenome &champion = champions[i];
        const bool is_asked = id ? champion.genome.id == *id : i + 1 == champions.size();
        known.append(" ").append(to_text(champion.genome.id));
        if (!is_asked) continue;
        const ChampionRow row = read_champions(run).at(i);
        return {champion.number, champion.genome,
                to_text(row.cells) + " cells, moved " + to_text(row.displacement) + " cells, fitness " +
                    to_text(row.fitness)};
    }
    throw InputError(file + ": genome " + to_text(*id) + " is not a champion; the champions are" + known +
                     "; name any other individual by --generation and --slot");
}

std::string life_text(const Individual &individual) {
    const Life &life = individual.life;
    return std::string(name_of(life.outcome)) + ", " + to_text(life.cells) + " cells (" +
           to_text(life.births) + " created), moved " + to_text(life.displacement()) + " cells from (" +
           to_text(life.rest.x) + ", " + to_text(life.rest.y) + ") to (" + to_text(life.finish.x) + ", " +
           to_text(life.finish.y) + "), fitness " + to_text(individual.evaluation.fitness) + ", score " +
           to_text(individual.score);
}

/// The individual of --generation and --slot.
Shown individual_of(const Arguments &arguments, const RecordedRun &run) {
    if (!arguments.has("generation") || !arguments.has("slot"))
        throw UsageError("--generation and --slot are given together: they name an individual");
    if (arguments.has("genome"))
        throw UsageError("give either --genome, which names a champion, or --generation and --slot, which "
                         "name any individual");
    const int generation = arguments.whole("generation", 0, 0), slot = arguments.whole("slot", 0, 0);
    const SettingForRun own = recorded_setting(run);
    const Interrupt interrupt;
    const Individual individual = replay_individual(run, own.spec, generation, slot, threads_of(arguments),
                                                    [&] { return interrupt.requested(); });
    return {generation, individual.genome, life_text(individual)};
}

int print_genome(const Arguments &arguments, Console &console) {
    const std::optional<std::int64_t> asked = asked_genome(arguments);
    const RecordedRun run = read_run(arguments.operands.at(0));
    const bool by_place = arguments.has("generation") || arguments.has("slot");
    const Shown shown = by_place ? individual_of(arguments, run) : champion_of(run, asked);
    const std::string title = run.setting + ", seed " + to_text(run.seed) + ", generation " +
                              to_text(shown.generation) + ", genome " + to_text(shown.genome.id);
    if (arguments.has("svg")) write_new_file(arguments.text("svg"), svg_of(shown.genome, title));
    if (arguments.has("dot")) write_new_file(arguments.text("dot"), dot_of(shown.genome));
    if (arguments.has("csv")) write_new_file(arguments.text("csv"), table_text(shown.genome));
    if (arguments.has("svg") || arguments.has("dot") || arguments.has("csv")) return 0;
    console.out << title << '\n' << shown.life << '\n' << description_of(shown.genome);
    return 0;
}

} // namespace

const Command &lineage_command() {
    static const Command command{
        "lineage",
        "RUN",
        "prints the ancestors of an individual, mother by mother",
        R"(RUN is the folder of a complete run. Prints a CSV table, the oldest ancestor first; planula columns explains it under
lineage.csv.)",
        lineage_options,
        print_lineage};
    return command;
}

const Command &genome_command() {
    static const Command command{
        "genome",
        "RUN",
        "prints the genome and the evaluation of an individual, or draws its network",
        R"(RUN is the folder of a complete run. The genomes of champions, individuals that were fitter than all before them in the run,
are recorded. Any other individual is computed again, from the nearest saved state up to its generation; if that
generation differs from the record, the command ends with an error.

In the picture, wide links are strong, blue ones have a positive weight and red ones a negative one.)",
        genome_options,
        print_genome};
    return command;
}

} // namespace planula
