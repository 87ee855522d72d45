// SPDX-License-Identifier: MIT
#include "analysis/audit.h"

#include "analysis/history.h"
#include "analysis/replay.h"
#include "base/error.h"
#include "base/random.h"
#include "base/state.h"
#include "base/text.h"
#include "experiment/run_state.h"
#include "parameters/parameters.h"
#include "record/chain.h"
#include "record/kept_state.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace planula {

namespace {

/// The link before a generation.
std::string link_before(const RecordedRun &run, const std::vector<ChainRow> &chain, int generation) {
    return generation == 0 ? chain_start(run.identity.sha256())
                           : chain.at(static_cast<std::size_t>(generation) - 1).link;
}

/// The highest fitness of all generations before this one; nothing before the first.
std::optional<double> best_before(const RecordedRun &run, int generation) {
    std::optional<double> best;
    for (const ChampionRow &champion : read_champions(run))
        if (champion.generation < generation) best = champion.fitness;
    return best;
}

/// What the manifest says twice, or says of what identity.csv has.
void check_numbers(const RecordedRun &run) {
    const auto refuse = [&](const std::string &key) {
        throw InputError((run.folder / ManifestRow::file_name).string() + ": the row '" + key +
                         "' does not agree with the run");
    };
    const ParameterRow &row = parameter_row("population");
    const std::string population =
        run.identity.item("parameter population", value_text(row, row.standard)).value;
    if (population != to_text(static_cast<double>(run.population))) refuse("population");
    if (run.manifest.number("evaluations") != std::int64_t{run.generations} * run.population)
        refuse("evaluations");
    if (run.manifest.text("record") != name_of(run.record)) refuse("record");
}

/// Those after the run's end are of a process that is making it longer.
void check_states(const RecordedRun &run, const std::vector<ChainRow> &chain) {
    for (const int generation : kept_generations(run.folder)) {
        // A process that makes the run longer may have kept further ones.
        if (generation >= run.generations) break;
        const std::filesystem::path path = state_path(run.folder, generation);
        const std::optional<KeptState> kept = read_state(path);
        if (!kept) throw InputError(path.string() + ": the file is damaged");
        if (kept->identity != run.identity.sha256() || kept->generation != generation ||
            kept->link != link_before(run, chain, generation))
            throw InputError(path.string() + ": it is not the state before generation " +
                             to_text(generation) + " of this run");
    }
}

/// Compares generations with the record, one after another.
class Comparison {
  public:
    Comparison(const RecordedRun &run, const Spec &setting, int first)
        : run_(run), setting_(setting), chain_(read_chain(run.folder)), best_(best_before(run, first)) {
        setting_.record = run.record;
    }

    void compare(const Generation &generation) {
        const double fitness = generation.evaluations[generation.best].fitness;
        const bool has_new_champion = !best_ || fitness > *best_;
        if (has_new_champion) best_ = fitness;
        const RowTexts rows =
            row_texts(generation, setting_, static_cast<std::uint64_t>(run_.seed), has_new_champion);
        const ChainRow row = chain_row(link_before(run_, chain_, generation.number), generation, rows);
        const ChainRow &recorded = chain_.at(static_cast<std::size_t>(generation.number));
        if (row.content == recorded.content && row.link == recorded.link) return;
        throw InputError(
            run_.folder.string() + ": generation " + to_text(generation.number) +
            " is not what simulating it again gives: " +
            (row.content == recorded.content ? "its rows differ" : "its genomes or lives differ"));
    }

    /// The state that a stretch leads to must be the kept one.
    void compare(const RunState &state) const {
        const std::filesystem::path path = state_path(run_.folder, state.population.generation);
        if (!std::filesystem::exists(path)) return;
        StateWriter saved;
        save(state, saved);
        const std::optional<KeptState> kept = read_state(path);
        if (!kept || kept->state != saved.bytes() || kept->best_fitness != best_ ||
            kept->archive != static_cast<std::int64_t>(state.search->archive().size()))
            throw InputError(path.string() + ": the kept state is not what simulating up to it gives");
    }

  private:
    const RecordedRun &run_;
    Spec setting_;
    const std::vector<ChainRow> chain_;
    std::optional<double> best_;
};

} // namespace

void check_consistency(const RecordedRun &run) {
    const std::vector<ChainRow> chain = read_chain(run.folder);
    const std::string file = (run.folder / ChainRow::file_name).string();
    if (static_cast<int>(chain.size()) != run.generations)
        throw InputError(file + ": it has " + to_text(static_cast<std::int64_t>(chain.size())) +
                         " generations, where the manifest says " + to_text(run.generations));
    try {
        check_chain(run.folder, run.identity.sha256(), chain);
    } catch (const InputError &generation) {
        // The manifest may say which file it is.
        try {
            check_files(run);
        } catch (const InputError &changed) {
            throw InputError(std::string(generation.what()) + "\n" + changed.what());
        }
        throw;
    }
    if (chain.back().link != run.manifest.text("link"))
        throw InputError(file + ": it does not end with the link that the manifest says");
    check_files(run);
    check_numbers(run);
    check_states(run, chain);
}

std::vector<Stretch> stretches(const RecordedRun &run) {
    std::vector<Stretch> all;
    int first = 0;
    for (const int kept : kept_generations(run.folder)) {
        if (kept <= first || kept >= run.generations) continue;
        all.push_back({first, kept - 1});
        first = kept;
    }
    all.push_back({first, run.generations - 1});
    return all;
}

void recompute(const RecordedRun &run, const Spec &setting, const Stretch &stretch, const Workers &workers,
               const StopRequest &stop) {
    Comparison comparison(run, setting, stretch.first);
    const auto observe = [&](const Generation &generation) { comparison.compare(generation); };
    const auto observe_state = [&](const RunState &state) {
        if (state.population.generation == stretch.last + 1) comparison.compare(state);
    };
    replay(run, setting, stretch.first, stretch.last, workers, observe, stop, observe_state);
}

std::vector<int> drawn_order(int count, std::uint64_t draw) {
    Stream stream(draw, 0, 0, Purpose::sampling);
    std::vector<int> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), 0);
    for (int left = count; left > 1; --left)
        std::swap(order[static_cast<std::size_t>(left) - 1],
                  order[stream.below(static_cast<std::uint32_t>(left))]);
    return order;
}

} // namespace planula
