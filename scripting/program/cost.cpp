// SPDX-License-Identifier: MIT
#include "program/cost.h"

#include "base/state.h"
#include "base/text.h"
#include "experiment/run_state.h"
#include "experiment/sample.h"
#include "program/progress.h"
#include "record/kept_state.h"
#include "storage/packed.h"

#include <algorithm>
#include <ctime>

#include <sys/resource.h>

namespace planula {

namespace {

constexpr double megabyte = 1e6;

double packed_size(const std::string &text) { return static_cast<double>(pack(text).size()); }

/// Individuals that a run of this setting records.
double recorded_individuals(const Spec &setting) {
    const Parameters &p = setting.parameters;
    if (setting.record.full) return static_cast<double>(p.neat.population) * p.design.generations;
    double individuals = 0;
    for (int generation = 0; generation < p.design.generations; ++generation)
        individuals += p.neat.population * setting.record.share(p.neat.population, generation + 1);
    return individuals;
}

/// Saved states of a complete run: those kept permanently, and the one before the last generation.
int kept_states(int generations) {
    int states = 1;
    for (int generation = 1; generation < generations - 1; ++generation)
        states += is_kept_generation(generation);
    return states;
}

} // namespace

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024 / megabyte;
}

Measured measure(const Spec &setting, std::uint64_t seed, int generations, int threads,
                 const StopRequest &stop, const Observer &observe) {
    Spec spec = setting;
    spec.record = full_record;
    spec.parameters.design.generations = std::min(generations, setting.parameters.design.generations);
    const bool is_short = spec.parameters.design.generations == 1;
    Measured measured;
    measured.population = spec.parameters.neat.population;
    double began = processor_seconds();
    RunState state = begin(spec, seed, threads, stop);
    const auto note = [&](const Generation &generation) {
        observe(generation);
        if (generation.number == 0 && !is_short) {
            began = processor_seconds();
            return;
        }
        ++measured.generations;
        measured.seconds = std::max(processor_seconds() - began, 1e-6); // the clock's resolution
        measured.evaluations += static_cast<std::int64_t>(generation.lives.size());
        const RowTexts rows = row_texts(generation, spec, seed, false);
        for (std::size_t i = 0; i < rows.size(); ++i) measured.rows[i] += rows[i];
        measured.archive = static_cast<double>(generation.search.archive().size()) / (generation.number + 1);
    };
    run(
        spec, seed, threads, state, note, [](const RunState &) {}, stop);
    StateWriter saved;
    save(state, saved);
    measured.state_bytes = packed_size(saved.bytes());
    return measured;
}

Cost cost_of(const Spec &setting, const Measured &measured) {
    const Parameters &p = setting.parameters;
    const double each = 1.0 / measured.generations;
    const double larger = static_cast<double>(p.neat.population) / measured.population;
    Cost cost;
    cost.core_seconds = measured.seconds / static_cast<double>(measured.evaluations) * p.neat.population *
                        p.design.generations;
    for (std::size_t i = 0; i < run_tables.size(); ++i) {
        const std::string &rows = measured.rows[i];
        const bool is_of_individuals = run_tables[i] == IndividualRow::file_name;
        const double times = is_of_individuals ? larger : 1;
        double generations = p.design.generations * each;
        if (is_of_individuals) generations = recorded_individuals(setting) / p.neat.population * each;
        const bool is_packed = run_tables[i].ends_with(".gz");
        constexpr double gzip = 1.1; // times as much as pack() makes of individuals
        cost.table_bytes +=
            (is_packed ? gzip * packed_size(rows) : static_cast<double>(rows.size())) * generations * times;
        cost.journal_bytes += static_cast<double>(rows.size()) * generations * times;
    }
    constexpr double link_bytes = 140; // of a row of chain.csv
    cost.table_bytes += link_bytes * p.design.generations;
    cost.state_bytes = measured.state_bytes * larger * kept_states(p.design.generations);
    constexpr double entry_bytes = 200; // in memory, its place in the index included
    cost.archive_bytes = measured.archive * entry_bytes * p.design.generations;
    return cost;
}

std::string long_time(double seconds) {
    constexpr double day = 86400;
    if (seconds < 2 * day) return duration_text(seconds);
    return to_fixed(seconds / day, 1) + " days";
}

std::string size_text(double bytes) {
    if (bytes < 100 * megabyte) return to_fixed(bytes / megabyte, 1) + " MB";
    return to_fixed(bytes / (1000 * megabyte), 2) + " GB";
}

std::string evaluations_text(double evaluations) {
    constexpr double million = 1e6;
    if (evaluations < million) return to_fixed(evaluations, 0) + " evaluations";
    return to_fixed(evaluations / million, 2) + " million evaluations";
}

} // namespace planula
