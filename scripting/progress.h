// SPDX-License-Identifier: MIT
// How far a command is, for the person who waits: on a terminal one line that is rewritten, else a plain line
// about every ten seconds. Several runs, each on its own thread, may tell of themselves. Reads the clock, and decides
// nothing.
#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <mutex>
#include <string>

namespace planula {

class Progress {
  public:
    /// `evaluations`: of all runs that the command has to do.
    Progress(std::ostream &out, bool terminal, std::int64_t evaluations);
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// A run that is going on, for as long as this lives.
    class Open {
      public:
        explicit Open(Progress &progress) : progress_(progress) { progress_.open(1); }
        ~Open() { progress_.open(-1); }
        Open(const Open &) = delete;
        Open &operator=(const Open &) = delete;

      private:
        Progress &progress_;
    };

    /// So many evaluations of the planned ones were done by an earlier process.
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

    std::ostream &out_;
    const bool terminal_;
    std::mutex mutex_; // of all below and of out_
    std::int64_t planned_;
    std::int64_t done_ = 0;
    int open_ = 0;         // runs
    bool on_line_ = false; // the rewritten line is on the screen
    Clock::time_point start_ = Clock::now(), shown_ = start_;
};

/// "3 h 20 min", "4 min 5 s", "12 s".
std::string duration_text(double seconds);

} // namespace planula
