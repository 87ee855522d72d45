// SPDX-License-Identifier: MIT
// How long a command will still take, from how long its generations took. Settings differ in cost, so each is measured on
// its own by the time that its evaluations kept threads busy; one that has not been seen counts as the mean of those
// that have. How much busy time there is in a second is measured over all runs together: threads do not share their
// time evenly among the runs that are computed at once. What happened lately counts more than what happened long ago.
// Reads no clock: every function is given the seconds since some moment, which never fall.
#pragma once

#include <cstdint>
#include <map>
#include <string>

namespace planula {

/// Evaluations by the name of the setting.
using Workload = std::map<std::string, std::int64_t, std::less<>>;

class TimeLeft {
  public:
    /// A run begins or ends to be computed.
    void open(double now);
    void close(double now);
    /// A run has done so many evaluations since it was opened, or since it reported last, which took `busy` seconds of
    /// threads.
    void done(const std::string &setting, double evaluations, double busy, double now);

    /// Evaluations per second lately, of all runs together; 0 until enough is measured to say so.
    double rate() const;
    /// Seconds that these evaluations will take; 0 until enough is measured.
    double seconds(const Workload &left) const;

  private:
    /// Sums over reports, old ones with less weight.
    struct Measured {
        double evaluations = 0, busy = 0, seconds = 0;
        void add(double more_evaluations, double more_busy, double more_seconds);
        /// Busy seconds of an evaluation.
        double cost() const { return busy / evaluations; }
    };
    bool is_known() const;
    void advance(double now);

    int open_ = 0, most_open_ = 0; // runs
    double now_ = 0, window_ = 0,
           passed_ = 0; // of the time with an open run: since the last report, and until it
    std::map<std::string, Measured, std::less<>> settings_;
    Measured lately_; // of all settings
    int reports_ = 0;
};

} // namespace planula
