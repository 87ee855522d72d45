// SPDX-License-Identifier: MIT
// How long a command will still take, from how long its generations took. Settings differ in cost, so each is measured on
// its own, and one that has not been seen counts as the mean of those that have. Runs that are computed at the same time
// share the machine: the time of a generation is its share of it. What a setting cost lately counts more than what it
// cost long ago. Reads no clock: every function is given the seconds since some moment, which never fall.
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
    void open(const std::string &run, double now);
    void close(const std::string &run, double now);
    /// The run has done so many evaluations since it was opened, or since it reported last.
    void done(const std::string &run, const std::string &setting, double evaluations, double now);

    /// Evaluations per second lately, of all runs together; 0 until enough is measured to say so.
    double rate() const;
    /// Seconds that these evaluations will take; 0 until enough is measured.
    double seconds(const Workload &left) const;

  private:
    /// Seconds of the whole machine for so many evaluations, old ones with less weight.
    struct Cost {
        double seconds = 0, evaluations = 0;
        void add(double more_seconds, double more_evaluations);
    };
    bool is_known() const;
    void advance(double now);

    std::map<std::string, double> open_; // runs, each with the shared time at which it reported last
    double now_ = 0, shared_ = 0; // the time, and the time that each open run had the machine to itself
    std::map<std::string, Cost, std::less<>> costs_;
    Cost lately_; // of all settings
    double measured_ = 0;
    int reports_ = 0;
};

} // namespace planula
