// SPDX-License-Identifier: MIT
#include "program/individual.h"

#include "analysis/history.h"
#include "analysis/replay.h"
#include "base/error.h"
#include "base/text.h"
#include "program/commands.h"
#include "program/interrupt.h"
#include "storage/output.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <algorithm>
#include <vector>

namespace planula {

namespace {

AskedIndividual champion_of(const RecordedRun &run, std::optional<std::int64_t> id) {
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
        return {champion.number,
                row.slot,
                champion.genome,
                row.fitness,
                row.displacement,
                row.cells,
                to_text(row.cells) + " cells, moved " + to_text(row.displacement) + " cells, fitness " +
                    to_text(row.fitness)};
    }
    throw InputError(file + ": genome " + to_text(*id) + " is not a champion; the champions are" + known +
                     "; name any other individual by --generation and --slot");
}

std::string text_of(const Individual &individual) {
    const Life &life = individual.life;
    return std::string(name_of(life.outcome)) + ", " + to_text(life.cells) + " cells (" +
           to_text(life.births) + " created), moved " + to_text(life.displacement()) + " cells from (" +
           to_text(life.rest.x) + ", " + to_text(life.rest.y) + ") to (" + to_text(life.finish.x) + ", " +
           to_text(life.finish.y) + "), fitness " + to_text(individual.evaluation.fitness) + ", score " +
           to_text(individual.score);
}

/// The individual of --generation and --slot.
AskedIndividual individual_at(const Arguments &arguments, const RecordedRun &run) {
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
    return {generation,
            slot,
            individual.genome,
            individual.evaluation.fitness,
            individual.life.displacement(),
            individual.life.cells,
            text_of(individual)};
}

} // namespace

RecordedRun asked_run(const Arguments &arguments) {
    const std::filesystem::path folder = arguments.operands.at(0);
    const std::vector<std::filesystem::path> runs = folders_with_runs(folder);
    if (runs.size() < 2) return read_run(runs.empty() ? folder : runs.front());
    std::string names;
    constexpr std::size_t most = 3;
    for (std::size_t i = 0; i < std::min(most, runs.size()); ++i)
        names += (i == 0 ? "" : ", ") + runs[i].string();
    throw InputError(folder.string() + " holds " + to_text(static_cast<std::int64_t>(runs.size())) +
                     " runs; name one of them: " + names + (runs.size() > most ? ", …" : ""));
}

std::optional<std::int64_t> asked_genome(const Arguments &arguments) {
    const std::string word = arguments.text("genome", "best");
    if (word == "best") return std::nullopt;
    const auto id = parse_int(word);
    if (!id || *id < 0)
        throw UsageError("--genome takes the number of a genome, or best, not '" + word + "'");
    return id;
}

AskedIndividual asked_individual(const Arguments &arguments, const RecordedRun &run) {
    const std::optional<std::int64_t> champion = asked_genome(arguments);
    const bool by_place = arguments.has("generation") || arguments.has("slot");
    return by_place ? individual_at(arguments, run) : champion_of(run, champion);
}

std::string title_of(const AskedIndividual &individual, const RecordedRun &run) {
    return run.setting + ", seed " + to_text(run.seed) + ", generation " + to_text(individual.generation) +
           ", genome " + to_text(individual.genome.id);
}

void check_replaceable(const std::filesystem::path &path) {
    if (std::filesystem::exists(path) && !std::filesystem::is_regular_file(path))
        throw CreateError(path.string() + " exists and is not a file; it is not replaced");
}

void write_new_file(const std::filesystem::path &path, const std::string &text) {
    check_replaceable(path);
    write_file(path, text);
}

} // namespace planula
