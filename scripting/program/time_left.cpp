// SPDX-License-Identifier: MIT
#include "program/time_left.h"

namespace planula {

namespace {

// Less than this says little: the first generations of runs that begin are unlike the later ones.
constexpr double least_seconds = 10;
constexpr int least_reports = 3;
constexpr double kept = 0.96; // weight of a report when the next one comes: the last 25 count

} // namespace

void TimeLeft::Cost::add(double more_seconds, double more_evaluations) {
    seconds = kept * seconds + more_seconds;
    evaluations = kept * evaluations + more_evaluations;
}

void TimeLeft::advance(double now) {
    if (!open_.empty()) shared_ += (now - now_) / static_cast<double>(open_.size());
    now_ = now;
}

void TimeLeft::open(const std::string &run, double now) {
    advance(now);
    open_[run] = shared_;
}

void TimeLeft::close(const std::string &run, double now) {
    advance(now);
    open_.erase(run);
}

void TimeLeft::done(const std::string &run, const std::string &setting, double evaluations, double now) {
    if (!open_.contains(run)) open(run, now_);
    advance(now);
    double &reported = open_[run];
    const double seconds = shared_ - reported;
    reported = shared_;
    costs_[setting].add(seconds, evaluations);
    lately_.add(seconds, evaluations);
    measured_ += seconds;
    ++reports_;
}

bool TimeLeft::is_known() const {
    return measured_ >= least_seconds && reports_ >= least_reports && lately_.evaluations > 0;
}

double TimeLeft::rate() const { return is_known() ? lately_.evaluations / lately_.seconds : 0; }

double TimeLeft::seconds(const Workload &left) const {
    if (!is_known()) return 0;
    double known = 0, settings = 0;
    for (const auto &[name, cost] : costs_)
        if (cost.evaluations > 0) known += cost.seconds / cost.evaluations, settings += 1;
    double seconds = 0;
    for (const auto &[name, evaluations] : left) {
        const auto own = costs_.find(name);
        const bool is_measured = own != costs_.end() && own->second.evaluations > 0;
        const double each = is_measured ? own->second.seconds / own->second.evaluations : known / settings;
        seconds += each * static_cast<double>(evaluations);
    }
    return seconds;
}

} // namespace planula
