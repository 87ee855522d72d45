// SPDX-License-Identifier: MIT
// The progress of a command, for the user: on a terminal one line that is rewritten, else a line about every ten
// seconds. Several runs, each on its own thread, may report to it. It shows how many runs have reached the present
// level, a number of generations, and how long this level and all levels will take at the present rate. It reads the
// clock, and no result depends on it.
#pragma once

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
    double rate = 0;               // evaluations per second; 0: not known yet
    double seconds_left_level = 0; // at this rate
    double seconds_left = 0;       // of all levels
};

class Progress {
  public:
    /// `evaluations`: how many the command has to do in all. `share(standing)` is called every few seconds.
    Progress(
        std::ostream &out, bool terminal, std::int64_t evaluations,
        std::function<void(const Standing &)> share = [](const Standing &) {});
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// Begins a level: how many runs it has, how many of them have reached it already, and the evaluations left to do.
    void begin_level(int level, int levels_left, int runs, int runs_done, std::int64_t evaluations);
    /// A run has reached the level.
    void reach();

    /// A run that is being computed, as long as this exists.
    class Open {
      public:
        explicit Open(Progress &progress) : progress_(progress) { progress_.open(1); }
        ~Open() { progress_.open(-1); }
        Open(const Open &) = delete;
        Open &operator=(const Open &) = delete;

      private:
        Progress &progress_;
    };

    /// Takes evaluations from the planned ones, or adds them if below 0.
    void skip(std::int64_t evaluations);
    /// Reports a generation: its number, from 0, the number of generations of the run, its best fitness so far, and the
    /// evaluations of the generation.
    void generation(const std::string &run, int number, int generations, double best, int evaluations);
    /// Prints a line that stays on the screen.
    void tell(const std::string &line);

  private:
    using Clock = std::chrono::steady_clock;
    void open(int runs);
    void clear_line();
    Standing standing(Clock::time_point now) const;

    std::ostream &out_;
    const bool terminal_;
    const std::function<void(const Standing &)> share_;
    std::mutex mutex_; // of all below and of out_
    std::int64_t planned_, planned_level_;
    std::int64_t done_ = 0, done_level_ = 0;
    int level_ = 0, levels_left_ = 0, runs_ = 1, runs_done_ = 0;
    int open_ = 0;         // runs
    bool on_line_ = false; // the rewritten line is on the screen
    Clock::time_point start_ = Clock::now(), shown_ = start_, shared_ = start_;
};

/// "3 h 20 min", "4 min 5 s", "12 s".
std::string duration_text(double seconds);

} // namespace planula
