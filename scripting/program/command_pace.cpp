// SPDX-License-Identifier: MIT
#include "base/text.h"
#include "experiment/run.h"
#include "program/commands.h"
#include "program/interrupt.h"
#include "program/progress.h"
#include "tables/csv.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <ostream>

namespace planula {

namespace {

constexpr int generations_of_a_row = 10; // after generation 0, which is a row by itself
constexpr std::uint64_t paced_seed = 1;

constexpr Option options[] = {
    {"until", "N", "last generation to measure, from 0 (default: 50)"},
    threads_option,
    lanes_option,
    set_option,
};

/// Processor time of this process so far, all threads together, in seconds.
double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double in_tenths(double value) { return std::floor(10 * value + 0.5) / 10; }

/// Core-seconds of all runs of a setting if every individual takes `seconds_each`.
double cost(const Parameters &design, double seconds_each) {
    return seconds_each * design.design.seeds * design.design.generations * design.neat.population;
}

/// The rows of one setting, generation by generation.
class Stopwatch {
  public:
    explicit Stopwatch(std::string setting) : setting_(std::move(setting)) {}

    void observe(const Generation &generation) {
        if (rows_.empty() || generation.number % generations_of_a_row == 1) begin_row(generation.number);
        PaceRow &row = rows_.back();
        row.last = generation.number;
        row.evaluations += static_cast<int>(generation.lives.size());
        row.known += generation.known.lives + generation.known.movements;
        for (const Life &life : generation.lives) {
            if (life.outcome != Outcome::viable) continue;
            cells_ += life.cells;
            ++viable_;
        }
        // The time to make the offspring of a generation counts with the next one.
        row.cells = viable_ > 0 ? in_tenths(static_cast<double>(cells_) / static_cast<double>(viable_)) : 0;
        row.core_seconds = processor_seconds() - began_;
        row.rate = in_tenths((row.evaluations - row.known) / row.core_seconds);
    }

    const std::vector<PaceRow> &rows() const { return rows_; }

  private:
    void begin_row(int generation) {
        if (!rows_.empty()) began_ += rows_.back().core_seconds;
        cells_ = viable_ = 0;
        rows_.push_back({.setting = setting_, .first = generation});
    }

    const std::string setting_;
    std::vector<PaceRow> rows_;
    double began_ = processor_seconds();
    std::int64_t cells_ = 0, viable_ = 0; // of the last row
};

class PaceCommand {
  public:
    PaceCommand(const Arguments &arguments, Console &console)
        : console_(console), threads_(threads_of(arguments)), design_(experiment_of(arguments, console)),
          experiment_(experiment_of(arguments, console, {{"generations", until(arguments) + 1}})) {
        use_lanes_of(arguments);
    }

    int run() {
        Workload evaluations;
        for (const Spec &setting : experiment_.settings)
            evaluations[setting.name] =
                std::int64_t{setting.parameters.neat.population} * setting.parameters.design.generations;
        Progress progress(console_.err, console_.terminal, evaluations);
        console_.out << header_line<PaceRow>();
        double all_seconds = 0, individuals = 0, simulated = 0, measured = 0;
        for (std::size_t i = 0; i < experiment_.settings.size(); ++i) {
            const std::vector<PaceRow> rows = evolve(i, progress);
            for (const PaceRow &row : rows) console_.out << line_of(row) << std::flush;

            // What is not measured is assumed to be as fast as the last row.
            const PaceRow &last = rows.back();
            all_seconds += cost(design_.settings[i].parameters, last.core_seconds / last.evaluations);
            individuals += cost(design_.settings[i].parameters, 1);
            simulated += last.evaluations - last.known;
            measured += last.core_seconds;
        }
        progress.tell("all settings, in the last row of each: " + to_fixed(simulated / measured, 0) +
                      " evaluations per core-second");
        progress.tell("the whole design of " + experiment_.name + ", " + to_fixed(individuals / 1e6, 1) +
                      " million individuals, at this pace: " + to_fixed(all_seconds / 3600, 0) +
                      " core-hours");
        return 0;
    }

  private:
    static double until(const Arguments &arguments) { return arguments.whole("until", 0, 50); }

    std::vector<PaceRow> evolve(std::size_t index, Progress &progress) const {
        const Spec &setting = experiment_.settings[index];
        experiment_.functions[index]->begin_run();
        Stopwatch stopwatch(setting.name);
        double best = 0;
        const Progress::Open open(progress);
        planula::run(
            setting, paced_seed, threads_,
            [&](const Generation &generation) {
                stopwatch.observe(generation);
                best = std::max(best, generation.evaluations[generation.best].fitness);
                progress.generation(report_of(setting, setting.name, generation, best));
            },
            [&] { return interrupt_.requested(); });
        return stopwatch.rows();
    }

    Console &console_;
    const int threads_;
    const Experiment design_, experiment_; // as the script states it, and as it is measured
    const Interrupt interrupt_;
};

int measure_pace(const Arguments &arguments, Console &console) {
    return PaceCommand(arguments, console).run();
}

} // namespace

const Command &pace_command() {
    static const Command command{
        "pace",
        "FILE.lua",
        "measures the evaluations per core-second of evolving populations",
        R"(Evolves each setting with seed 1 and prints a CSV table: generation 0, then ten generations per row. Counts
processor time, on which other programs have little effect. Writes no file. At the end, reports how long all seeds and generations of
the script would take if they ran as fast as the last row.)",
        options,
        measure_pace};
    return command;
}

} // namespace planula
