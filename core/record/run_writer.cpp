// SPDX-License-Identifier: MIT
#include "record/run_writer.h"

#include "base/check.h"
#include "base/state.h"
#include "evolution/search.h"
#include "experiment/run_state.h"
#include "record/chain.h"
#include "record/complete_run.h"
#include "record/resume_point.h"
#include "tables/csv.h"

#include <algorithm>

namespace planula {

namespace {

bool has_archive(const Spec &spec) {
    return make_search(spec.search, spec.parameters, spec.aims)->keeps_archive();
}

/// A damaged checkpoint must not become the one that is kept beside a new one. The files in states/ are kept: the
/// manifest of a complete run names it.
void remove_damaged_checkpoints(const std::filesystem::path &folder, const ResumePoint &point) {
    for (const std::filesystem::path &path : point.damaged)
        if (path.parent_path() == folder) remove_file(path);
}

} // namespace

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
    const int complete = complete_generations(folder_);
    if (complete >= spec_.parameters.design.generations)
        remove_leftovers(folder_, complete);
    else
        resume(find_resume_point(folder_, identity_, complete));
}

RunWriter::~RunWriter() = default;

void RunWriter::resume(const ResumePoint &point) {
    damaged_ = point.damaged;
    generations_ = spec_.parameters.design.generations;
    if (point.kept) restore(point);
    tables_ = std::make_unique<RunTables>(
        folder_, has_archive(spec_), [&](std::string_view table) { return point.start_of(table); },
        spec_.aims);
    remove_damaged_checkpoints(folder_, point);

    // A run that was to be longer may stand before what is its last generation now.
    if (point.kept && is_kept_at_end(observed_, generations_) &&
        !std::filesystem::exists(state_path(folder_, observed_)))
        keep_state(folder_, *point.kept);
}

void RunWriter::restore(const ResumePoint &point) {
    const KeptState &kept = *point.kept;
    generations_ = std::max(generations_, kept.generation + 1);
    Spec longest = spec_;
    longest.parameters.design.generations = generations_;
    state_ = point.load(folder_, longest);
    observed_ = kept.generation;
    if (point.tables == JournalStart::From::journal) kept_ = observed_;
    best_fitness_ = kept.best_fitness;
    memory_ = kept.memory;
    link_ = kept.link;
}

void RunWriter::observe(const Generation &generation) {
    CHECK(generation.number == observed_, generation.number, observed_);
    const std::size_t size = generation.population.genomes.size();
    CHECK(generation.lives.size() == size && generation.evaluations.size() == size &&
          generation.scores.size() == size);

    // A champion is the best of the first generation, and every individual fitter than all before.
    const double fitness = generation.evaluations[generation.best].fitness;
    const bool has_new_champion = observed_ == 0 || fitness > best_fitness_;
    if (has_new_champion) best_fitness_ = fitness;
    const RowTexts rows = row_texts(generation, spec_, seed_, has_new_champion);
    const ChainRow link = chain_row(link_, generation, rows);
    tables_->write(rows);
    tables_->write_link(line_of(link));
    link_ = link.link;
    ++observed_;
}

void RunWriter::before_generation(const RunState &state, const std::string &memory) {
    if (is_kept_at_end(observed_, generations_)) keep_state(folder_, kept_state(state, memory));
    if (observed_ - kept_.value_or(0) >= interval_) checkpoint(state, memory);
}

void RunWriter::checkpoint(const RunState &state, const std::string &memory) {
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
    complete_run({folder_, spec_, seed_, generations_, identity_, link_}, *tables_);
}

} // namespace planula
