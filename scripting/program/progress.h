// SPDX-License-Identifier: MIT
// The progress of a command, for the user: on a terminal one line that is rewritten, else a line about every ten
// seconds. Several runs, each on its own thread, may report to it. It shows how many runs have reached the present
// level, a number of generations, and how long this level and all levels will take (program/time_left.h). It reads the
// clock, and no result depends on it.
#pragma once

#include "experiment/run.h"
#include "program/time_left.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <string>

namespace planula {

/// How far a command is.
struct Standing {
    int level = 0;                 // generations of the present level
    int levels_left = 0;           // levels after it
    int runs = 0, runs_done = 0;   // of the present level, and those that have reached it
    std::int64_t evaluations = 0;  // by this command
    double rate = 0;               // evaluations per second lately; 0: not known yet
    double seconds_left_level = 0; // 0 if the rate is
    double seconds_left = 0;       // of all levels
};

/// A generation of a run that has been evaluated.
struct GenerationReport {
    std::string setting, run;        // the second as the line calls it, alone among the open ones
    int number = 0, generations = 0; // from 0, and those of the run
    double best = 0;                 // fitness so far
    std::string unit;                // of fitness; may be empty
    double viable = 0;               // share of the generation
    int evaluations = 0;
    double busy = 0; // seconds of threads that they took; 0: the time since the report before
};

/// The unit of a setting's fitness: that of the paper's function is a distance, what another one measures is not known.
std::string fitness_unit(const Spec &setting);

/// `best`: the run's fitness so far, in this generation at the latest.
GenerationReport report_of(const Spec &setting, const std::string &run, const Generation &generation,
                           double best);

class Progress {
  public:
    /// `planned`: the evaluations that the command has to do in all. `share(standing)` is called every few seconds.
    Progress(
        std::ostream &out, bool terminal, Workload planned,
        std::function<void(const Standing &)> share = [](const Standing &) {});
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// Begins a level: how many runs it has, how many of them have reached it already, and the evaluations that are left
    /// to do in it and in all levels from it on.
    void begin_level(int level, int levels_left, int runs, int runs_done, Workload planned_level,
                     Workload planned);
    /// A run has reached the level.
    void reach();

    /// A run that is being computed, as long as this exists.
    class Open {
      public:
        explicit Open(Progress &progress);
        ~Open();
        Open(const Open &) = delete;
        Open &operator=(const Open &) = delete;

        /// Does a task of the run and measures how long it takes. Any thread may call it.
        void measure(const std::function<void()> &task);
        /// The seconds of all tasks that were measured since this was called last.
        double take_busy();

      private:
        Progress &progress_;
        std::atomic<std::int64_t> busy_ = 0; // nanoseconds
    };

    void generation(const GenerationReport &report);
    /// Prints a line that stays on the screen.
    void tell(const std::string &line);

  private:
    using Clock = std::chrono::steady_clock;
    void clear_line();
    double seconds() const; // since the command began
    Standing standing() const;

    std::ostream &out_;
    const bool terminal_;
    const std::function<void(const Standing &)> share_;
    std::mutex mutex_;                 // of all below and of out_
    Workload planned_, planned_level_; // what is left of them
    std::int64_t done_ = 0;
    int level_ = 0, levels_left_ = 0, runs_ = 1, runs_done_ = 0;
    int open_ = 0; // runs
    TimeLeft left_;
    bool on_line_ = false; // the rewritten line is on the screen
    const Clock::time_point start_ = Clock::now();
    double shown_ = 0, shared_ = 0, reported_ = 0; // when that was done last
};

/// "3 h 20 min", "4 min 5 s", "12 s".
std::string duration_text(double seconds);

} // namespace planula
