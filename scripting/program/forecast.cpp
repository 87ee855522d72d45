// SPDX-License-Identifier: MIT
#include "program/forecast.h"

#include "base/state.h"
#include "base/text.h"
#include "experiment/run.h"
#include "experiment/run_state.h"
#include "experiment/sample.h"
#include "program/commands.h"
#include "program/interrupt.h"
#include "program/progress.h"
#include "record/kept_state.h"
#include "record/run_tables.h"
#include "storage/packed.h"

#include <algorithm>
#include <array>
#include <ctime>
#include <iomanip>
#include <ostream>
#include <sstream>

#include <sys/resource.h>

namespace planula {

namespace {

constexpr int measured_generations = 11; // generation 0, which is unlike the others, and ten more
constexpr double megabyte = 1e6;

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The most memory that this process has held so far, in MB.
double peak_megabytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_maxrss) * 1024 / megabyte;
}

double packed_size(const std::string &text) { return static_cast<double>(pack(text).size()); }

/// What the measured generations of a setting cost.
struct Measured {
    double seconds = 0; // of processor time, after generation 0
    std::int64_t evaluations = 0;
    RowTexts rows;          // of these generations, all individuals
    int generations = 0;    // after generation 0, or 1 if there is no other
    double state_bytes = 0; // of a saved state
    double archive = 0;     // entries of the archive, in a generation
};

Measured measure(const Spec &setting, std::uint64_t seed, int threads, const StopRequest &stop,
                 Progress &progress) {
    Spec spec = setting;
    spec.record = Recording::full;
    spec.parameters.design.generations =
        std::min(measured_generations, setting.parameters.design.generations);
    const bool is_short = spec.parameters.design.generations == 1;
    Measured measured;
    double began = processor_seconds();
    RunState state = begin(spec, seed, threads, stop);
    const auto observe = [&](const Generation &generation) {
        progress.generation(spec.name, generation.number, spec.parameters.design.generations,
                            generation.evaluations[generation.best].fitness, spec.parameters.neat.population);
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
        spec, seed, threads, state, observe, [](const RunState &) {}, stop);
    StateWriter saved;
    save(state, saved);
    measured.state_bytes = packed_size(saved.bytes());
    return measured;
}

/// Individuals that a run of this setting records.
double recorded_individuals(const Spec &setting) {
    const Parameters &p = setting.parameters;
    if (setting.record == Recording::full)
        return static_cast<double>(p.neat.population) * p.design.generations;
    double individuals = 0;
    for (int generation = 0; generation < p.design.generations; ++generation)
        individuals += p.neat.population *
                       sample_share(recorded_share, recorded_least, p.neat.population, generation + 1);
    return individuals;
}

/// Saved states of a complete run: those kept permanently, and the one before the last generation.
int kept_states(int generations) {
    int states = 1;
    for (int generation = 1; generation < generations - 1; ++generation)
        states += is_kept_generation(generation);
    return states;
}

/// What a run of a setting costs.
struct Cost {
    double core_seconds = 0, table_bytes = 0, state_bytes = 0, journal_bytes = 0, archive_bytes = 0;
};

Cost cost_of(const Spec &setting, const Measured &measured) {
    const Parameters &p = setting.parameters;
    const double each = 1.0 / measured.generations;
    Cost cost;
    cost.core_seconds = measured.seconds / static_cast<double>(measured.evaluations) * p.neat.population *
                        p.design.generations;
    for (std::size_t i = 0; i < run_tables.size(); ++i) {
        const std::string &rows = measured.rows[i];
        double generations = p.design.generations * each;
        if (run_tables[i] == IndividualRow::file_name)
            generations = recorded_individuals(setting) / p.neat.population * each;
        const bool is_packed = run_tables[i].ends_with(".gz");
        constexpr double gzip = 1.1; // times as much as pack() makes of individuals
        cost.table_bytes +=
            (is_packed ? gzip * packed_size(rows) : static_cast<double>(rows.size())) * generations;
        cost.journal_bytes += static_cast<double>(rows.size()) * generations;
    }
    constexpr double link_bytes = 140; // of a row of chain.csv
    cost.table_bytes += link_bytes * p.design.generations;
    cost.state_bytes = measured.state_bytes * kept_states(p.design.generations);
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

class Forecast {
  public:
    Forecast(const Arguments &arguments, Console &console)
        : console_(console), experiment_(experiment_to_run(arguments, console)),
          threads_(threads_of(arguments)), cores_(arguments.whole("cores", 1, 0)),
          runs_(runs_of(arguments, experiment_)) {
        use_lanes_of(arguments);
        for (const PlannedRun &run : runs_)
            if (std::find(settings_.begin(), settings_.end(), run.setting) == settings_.end())
                settings_.push_back(run.setting);
    }

    int run() {
        measure_all();
        console_.out << "forecast of " << experiment_.name << ": " << runs_.size() << " runs, "
                     << to_fixed(evaluations_ / 1e6, 2) << " million evaluations\n";
        tell_settings();
        tell_whole();
        return 0;
    }

  private:
    void measure_all() {
        const Interrupt interrupt;
        std::int64_t evaluations = 0;
        for (const std::size_t i : settings_) {
            const Parameters &p = experiment_.settings[i].parameters;
            evaluations +=
                std::int64_t{std::min(measured_generations, p.design.generations)} * p.neat.population;
        }
        Progress progress(console_.err, console_.terminal, evaluations);
        for (const std::size_t i : settings_) {
            const SettingForRun own = setting_for_run(experiment_, i);
            measured_.push_back(measure(
                own.spec, runs_.front().seed, threads_, [&] { return interrupt.requested(); }, progress));
            costs_.push_back(cost_of(own.spec, measured_.back()));
        }
        for (const PlannedRun &run : runs_) {
            const Parameters &p = experiment_.settings[run.setting].parameters;
            evaluations_ += static_cast<double>(p.neat.population) * p.design.generations;
        }
    }

    std::string measured_words() const {
        int last = 0;
        for (const std::size_t i : settings_)
            last = std::max(
                last,
                std::min(measured_generations, experiment_.settings[i].parameters.design.generations) - 1);
        return last == 0 ? "generation 0" : "generations 1 to " + to_text(last);
    }

    void tell_settings() const {
        std::ostream &out = console_.out;
        out << "measured here: " << measured_words() << " of each setting, seed " << runs_.front().seed
            << "\n\n"
            << std::left << std::setw(24) << "setting" << std::right << std::setw(18) << "evaluations/core-s"
            << std::setw(18) << "core-hours a run" << std::setw(16) << "tables, MB" << std::setw(16)
            << "states, MB" << '\n';
        for (std::size_t i = 0; i < settings_.size(); ++i)
            out << std::left << std::setw(24) << experiment_.settings[settings_[i]].name << std::right
                << std::setw(18)
                << to_fixed(static_cast<double>(measured_[i].evaluations) / measured_[i].seconds, 0)
                << std::setw(18) << to_fixed(costs_[i].core_seconds / 3600, 3) << std::setw(16)
                << to_fixed(costs_[i].table_bytes / megabyte, 2) << std::setw(16)
                << to_fixed(costs_[i].state_bytes / megabyte, 2) << '\n';
    }

    void tell_whole() const {
        double seconds = 0, bytes = 0, longest = 0, journals = 0, archive = 0;
        for (const PlannedRun &run : runs_) {
            const auto at = std::find(settings_.begin(), settings_.end(), run.setting) - settings_.begin();
            const Cost &cost = costs_[static_cast<std::size_t>(at)];
            seconds += cost.core_seconds;
            bytes += cost.table_bytes + cost.state_bytes;
            longest = std::max(longest, cost.core_seconds);
            journals = std::max(journals, cost.journal_bytes);
            archive = std::max(archive, cost.archive_bytes);
        }
        std::ostream &out = console_.out;
        const auto on = [&](int cores) { return long_time(seconds / cores); };
        out << "\ntime:   " << to_fixed(seconds / 3600, 2) << " core-hours; " << on(threads_) << " on the "
            << threads_ << " threads of this command";
        if (cores_ > 0)
            out << "; " << long_time(std::max(seconds / cores_, longest)) << " on " << cores_
                << " cores of a cluster, one run on each";
        const double at_once = std::min<double>(threads_, static_cast<double>(runs_.size()));
        out << "\ndisk:   " << size_text(bytes) << " when all is complete, and up to "
            << size_text(journals * at_once) << " more while runs are unfinished"
            << "\nmemory: " << to_fixed(peak_megabytes() + archive * at_once / megabyte, 0) << " MB\n"
            << "\nThis assumes that later generations cost as much as those measured. Bodies change as they "
               "evolve: "
               "in runs\nof 100 generations of the paper's settings some became 1.7 times slower after "
               "generation 10, "
               "others not at all.\n";
    }

    Console &console_;
    const Experiment experiment_;
    const int threads_, cores_;
    const std::vector<PlannedRun> runs_;
    std::vector<std::size_t> settings_; // those of the runs
    std::vector<Measured> measured_;
    std::vector<Cost> costs_;
    double evaluations_ = 0;
};

} // namespace

int forecast(const Arguments &arguments, Console &console) { return Forecast(arguments, console).run(); }

} // namespace planula
