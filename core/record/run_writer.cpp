// SPDX-License-Identifier: MIT
#include "record/run_writer.h"

#include "base/check.h"
#include "base/error.h"
#include "base/state.h"
#include "base/text.h"
#include "evolution/search.h"
#include "experiment/run_state.h"
#include "record/chain.h"
#include "record/csv.h"
#include "record/input.h"

#include <algorithm>

namespace planula {

namespace {

bool has_archive(const Spec &spec) { return make_search(spec.search, spec.parameters)->keeps_archive(); }

/// Puts the file that an error of its content is about before what it says.
template <class Action> void about(const std::filesystem::path &path, Action &&action) {
    try {
        action();
    } catch (const InputError &error) {
        throw InputError(path.string() + ": " + error.what());
    }
}

/// Whether a checkpoint of a complete run is beyond its end: somebody is making it longer.
bool is_becoming_longer(const std::filesystem::path &folder, int done) {
    const std::vector<int> kept_ones = kept_generations(folder);
    if (!kept_ones.empty() && kept_ones.back() >= done) return true;
    for (const std::filesystem::path &path : checkpoints(folder)) {
        const std::optional<KeptState> kept = read_state(path);
        if (!kept || kept->generation >= done) return true;
    }
    return false;
}

} // namespace

/// Where a run resumes: a kept state, its file, and whether the tables up to there are journals or published.
struct RunWriter::Found {
    std::optional<KeptState> kept;
    std::filesystem::path path;
    JournalStart::From tables = JournalStart::From::nothing;
};

RunWriter::RunWriter(const std::filesystem::path &folder, const Spec &spec, std::uint64_t seed,
                     const RunSources &sources, int interval)
    : folder_(folder), spec_(spec), seed_(seed), interval_(interval) {
    CHECK(interval >= 1, interval);
    const RunRecord asked{identity_of(spec, seed), spec.record};
    check_same_run(folder_, asked);
    make_folder(folder_);
    lock_.emplace(folder_);

    // Another process may have been here until a moment ago.
    check_same_run(folder_, asked);
    const std::optional<RunRecord> recorded = recorded_run(folder_);
    if (!recorded) begin_folder(folder_, asked, sources);
    identity_ = (recorded ? *recorded : asked).identity.sha256();
    link_ = chain_start(identity_);
    open();
}

RunWriter::~RunWriter() = default;

/// Finds out what is to do, and opens the tables for it.
void RunWriter::open() {
    const int done = complete_generations(folder_);
    if (done >= spec_.parameters.design.generations) {
        // What a process that was killed at the very end left behind.
        if (!is_becoming_longer(folder_, done)) remove_journals(folder_);
        return;
    }
    const Found found = find_state(done);
    generations_ = spec_.parameters.design.generations;
    if (found.kept) generations_ = std::max(generations_, found.kept->generation + 1);
    resume(found);
}

/// Reads a kept state of the run, unless it is damaged.
bool RunWriter::take(const std::filesystem::path &path, JournalStart::From tables, Found &found) {
    found.kept = read_state(path);
    if (!found.kept) {
        damaged_.push_back(path);
        return false;
    }
    if (found.kept->identity != identity_)
        throw InputError(path.string() + ": it is a state of another run. Nothing was changed.");
    found.path = path;
    found.tables = tables;
    return true;
}

/// The newest state that is whole: a checkpoint, or one of states/. The first `done` generations are complete: a state
/// before the end of these belongs to the published tables, a later one to the journals.
RunWriter::Found RunWriter::find_state(int done) {
    using From = JournalStart::From;
    Found newest;
    for (const std::filesystem::path &path : checkpoints(folder_))
        if (take(path, From::journal, newest)) break;
    const int checkpoint = newest.kept ? newest.kept->generation : -1;
    std::vector<int> kept = kept_generations(folder_);
    for (; !kept.empty() && kept.back() > checkpoint; kept.pop_back()) {
        // Beyond what is published there are the journals of a process that was making the run longer.
        const From tables = kept.back() <= done ? From::target : From::journal;
        Found found;
        if (take(state_path(folder_, kept.back()), tables, found)) return found;
    }
    if (!newest.kept && (done > 0 || !damaged_.empty()))
        throw InputError(folder_.string() + ": no state of the run can be read" +
                         (damaged_.empty() ? "" : ", " + damaged_.front().string() + " is damaged") +
                         ": it cannot " + (done > 0 ? "become longer" : "resume") +
                         ". Nothing was changed. Move the folder away to begin the run again.");
    return newest;
}

void RunWriter::resume(const Found &found) {
    if (found.kept) restore(found);
    tables_ =
        std::make_unique<RunTables>(folder_, has_archive(spec_), [&](std::string_view table) -> JournalStart {
            if (!found.kept) return {};
            JournalStart start{found.tables, {}};
            about(found.path, [&] { start.mark = found.kept->mark_of(table); });
            return start;
        });

    // A damaged checkpoint must not become the one that is kept beside a new one. What lies in states/ stays: the manifest
    // of a complete run names it.
    for (const std::filesystem::path &path : damaged_)
        if (path.parent_path() == folder_) remove_file(path);

    // A run that was to be longer stands, it may be, before what is its last generation now.
    if (found.kept && is_to_stay(observed_) && !std::filesystem::exists(state_path(folder_, observed_)))
        keep_state(folder_, *found.kept);
}

void RunWriter::restore(const Found &found) {
    const KeptState &kept = *found.kept;
    const auto entries = static_cast<std::size_t>(kept.archive);
    const auto archive = found.tables == JournalStart::From::target ? read_archive(folder_, entries)
                                                                    : read_archive_journal(folder_, entries);
    Spec longest = spec_;
    longest.parameters.design.generations = generations_;
    about(found.path, [&] {
        StateReader state(kept.state);
        state_ = load_run_state(longest, archive, state);
        state.done();
        if (state_->population.generation != kept.generation) state.refuse("it is of another generation");
    });
    observed_ = kept.generation;
    if (found.tables == JournalStart::From::journal) kept_ = observed_;
    best_fitness_ = kept.best_fitness;
    memory_ = kept.memory;
    link_ = kept.link;
}

/// Whether the complete run has the state before this generation in states/.
bool RunWriter::is_to_stay(int generation) const {
    return is_kept_generation(generation) || generation == generations_ - 1;
}

void RunWriter::observe(const Generation &generation) {
    CHECK(generation.number == observed_, generation.number, observed_);
    const std::size_t size = generation.population.genomes.size();
    CHECK(generation.lives.size() == size && generation.evaluations.size() == size &&
          generation.scores.size() == size);

    // A champion is the best of the first generation, and everyone fitter than all before.
    const double fitness = generation.evaluations[generation.best].fitness;
    const bool crowned = observed_ == 0 || fitness > best_fitness_;
    if (crowned) best_fitness_ = fitness;
    const RowTexts rows = row_texts(generation, spec_, seed_, crowned);
    const ChainRow link = chain_row(link_, generation, rows);
    tables_->write(rows);
    tables_->write_link(line_of(link));
    link_ = link.link;
    ++observed_;
}

void RunWriter::between(const RunState &state, const std::string &memory) {
    if (is_to_stay(observed_)) keep_state(folder_, kept_state(state, memory));
    if (observed_ - kept_.value_or(0) >= interval_) keep(state, memory);
}

void RunWriter::keep(const RunState &state, const std::string &memory) {
    if (kept_ == observed_) return;
    write_checkpoint(folder_, kept_state(state, memory));
    kept_ = observed_;
}

/// The run as it stands, its tables being on disk.
KeptState RunWriter::kept_state(const RunState &state, const std::string &memory) {
    CHECK(state.population.generation == observed_, state.population.generation, observed_);
    StateWriter saved;
    save(state, saved);
    return {.identity = identity_,
            .generation = observed_,
            .tables = tables_->marks(),
            .link = link_,
            .archive = static_cast<std::int64_t>(state.search->archive().size()),
            .best_fitness = best_fitness_,
            .state = saved.bytes(),
            .memory = memory};
}

void RunWriter::finish() {
    CHECK(observed_ == generations_, observed_, generations_);
    // From here to the end there is no manifest; the journals hold everything.
    remove_file(folder_ / ManifestRow::file_name);
    const auto tables = tables_->publish();
    remove_other_states();
    write_manifest(tables);

    // Only what is complete needs no journals any more.
    remove_journals(folder_);
}

/// Of a shorter run that became longer, its last state goes.
void RunWriter::remove_other_states() const {
    for (const int generation : kept_generations(folder_))
        if (!is_to_stay(generation)) remove_file(state_path(folder_, generation));
}

void RunWriter::write_manifest(const std::vector<std::pair<std::string, std::string>> &tables) {
    Manifest manifest;
    manifest.add("version", std::string(version()));
    manifest.add("compiler", compiler());
    manifest.add("identity", identity_);
    manifest.add("setting", spec_.name);
    manifest.add("seed", static_cast<std::int64_t>(seed_));
    manifest.add("generations", generations_);
    manifest.add("population", spec_.parameters.neat.population);
    manifest.add("evaluations", std::int64_t{generations_} * spec_.parameters.neat.population);
    manifest.add("record", name_of(spec_.record));
    manifest.add("link", link_);
    const auto add_file = [&](const std::filesystem::path &path) {
        manifest.add(path.lexically_relative(folder_).generic_string(), content_sha256(path));
    };
    add_file(folder_ / IdentityRow::file_name);
    for (const std::filesystem::path &path : script_files(folder_)) add_file(path);
    for (const int generation : kept_generations(folder_)) add_file(state_path(folder_, generation));
    for (const auto &[file, hash] : tables) manifest.add(file, hash);
    manifest.seal();
    manifest.write(folder_);
}

void tidy_complete_run(const std::filesystem::path &folder) {
    if (!has_journals(folder)) return;
    std::optional<FolderLock> lock;
    try {
        lock.emplace(folder);
    } catch (const RefusedError &) {
        return;
    }
    const int done = complete_generations(folder);
    if (done > 0 && !is_becoming_longer(folder, done)) remove_journals(folder);
}

} // namespace planula
