// SPDX-License-Identifier: MIT
// How far a command is, for the person who waits: on a terminal one line that is rewritten, else a plain line
// about every ten seconds. Reads the clock, and decides nothing.
#pragma once

#include <chrono>
#include <cstdint>
#include <iosfwd>
#include <string>

namespace planula {

class Progress {
  public:
    /// `evaluations`: of all runs that the command has to do.
    Progress(std::ostream &out, bool terminal, std::int64_t evaluations);
    ~Progress();
    Progress(const Progress &) = delete;
    Progress &operator=(const Progress &) = delete;

    /// Begins a run of that many generations.
    void begin(std::string run, int generations);
    /// So many evaluations of the planned ones were done by an earlier process.
    void skip(std::int64_t evaluations) { planned_ -= evaluations; }
    /// A generation is done: its number from 0, the best fitness so far, its evaluations.
    void generation(int number, double best, int evaluations);
    /// Tells something that stays on the screen.
    void tell(const std::string &line);

  private:
    using Clock = std::chrono::steady_clock;
    void clear_line();

    std::ostream &out_;
    const bool terminal_;
    std::int64_t planned_;
    std::int64_t done_ = 0;
    std::string run_;
    int generations_ = 0;
    bool on_line_ = false; // the rewritten line is on the screen
    Clock::time_point start_ = Clock::now(), shown_ = start_;
};

/// "3 h 20 min", "4 min 5 s", "12 s".
std::string duration_text(double seconds);

} // namespace planula
