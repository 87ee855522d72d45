// SPDX-License-Identifier: MIT
// How far a command is, for the person who waits: on a terminal one line that is rewritten, else a plain line
// about every ten seconds. Several runs, each on its own thread, may tell of themselves. It speaks of the whole: how many
// runs have reached the present level (so many generations), and how long the level and all levels will take at the
// present pace. Reads the clock, and decides nothing.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <mutex>
#include <string>

namespace planula {

/// Where a command stands.
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
    /// `evaluations`: of all that the command has to do. `share(standing)` is called now and then, every few seconds.
    Progress(
        std::ostream &out, bool terminal, std::int64_t evaluations,
        std::function<void(const Standing &)> share = [](const Standing &) {});
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// Begins a level: so many runs, of which some have reached it already; the evaluations that it still takes.
    void begin_level(int level, int levels_left, int runs, int runs_done, std::int64_t evaluations);
    /// A run has reached the level.
    void reach();

    /// A run that is under way, for as long as this lives.
    class Open {
      public:
        explicit Open(Progress &progress) : progress_(progress) { progress_.open(1); }
        ~Open() { progress_.open(-1); }
        Open(const Open &) = delete;
        Open &operator=(const Open &) = delete;

      private:
        Progress &progress_;
    };

    /// So many evaluations of the planned ones are not to do after all, or (below 0) are to do in addition.
    void skip(std::int64_t evaluations);
    /// A generation of a run is done: its number from 0, of how many, the run's best fitness so far, its
    /// evaluations.
    void generation(const std::string &run, int number, int generations, double best, int evaluations);
    /// Tells something that stays on the screen.
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
