// SPDX-License-Identifier: MIT
#include "program/time_left.h"

#include <algorithm>

namespace planula {

namespace {

// Less than this says little: the first generations of runs that begin are unlike the later ones.
constexpr double least_seconds = 10;
constexpr int least_reports = 3;
constexpr double kept = 0.96; // weight of a report when the next one comes: the last 25 count

} // namespace

void TimeLeft::Measured::add(double more_evaluations, double more_busy, double more_seconds) {
    evaluations = kept * evaluations + more_evaluations;
    busy = kept * busy + more_busy;
    seconds = kept * seconds + more_seconds;
}

void TimeLeft::advance(double now) {
    if (open_ > 0) window_ += now - now_;
    now_ = now;
}

void TimeLeft::open(double now) {
    advance(now);
    most_open_ = std::max(most_open_, ++open_);
}

void TimeLeft::close(double now) {
    advance(now);
    --open_;
}

void TimeLeft::done(const std::string &setting, double evaluations, double busy, double now) {
    advance(now);
    settings_[setting].add(evaluations, busy, window_);
    lately_.add(evaluations, busy, window_);
    passed_ += window_;
    window_ = 0;
    ++reports_;
}

// Until each of the runs that are computed at once has reported, most of the busy time is not reported yet.
bool TimeLeft::is_known() const {
    return passed_ >= least_seconds && reports_ >= std::max(least_reports, most_open_) &&
           lately_.evaluations > 0 && lately_.busy > 0;
}

double TimeLeft::rate() const { return is_known() ? lately_.evaluations / lately_.seconds : 0; }

double TimeLeft::seconds(const Workload &left) const {
    if (!is_known()) return 0;
    double known = 0, settings = 0;
    for (const auto &[name, measured] : settings_)
        if (measured.evaluations > 0) known += measured.cost(), settings += 1;
    double busy = 0;
    for (const auto &[name, evaluations] : left) {
        const auto own = settings_.find(name);
        const bool is_measured = own != settings_.end() && own->second.evaluations > 0;
        busy += (is_measured ? own->second.cost() : known / settings) * static_cast<double>(evaluations);
    }
    return busy * lately_.seconds / lately_.busy;
}

} // namespace planula
