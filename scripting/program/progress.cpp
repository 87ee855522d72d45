// SPDX-License-Identifier: MIT
#include "program/progress.h"

#include "base/text.h"

#include <ostream>

namespace planula {

namespace {

constexpr double seconds_between_lines = 10;     // without a terminal
constexpr double seconds_between_rewrites = 0.2; // on a terminal
constexpr double seconds_between_shares = 5;

double seconds_from(std::chrono::steady_clock::time_point then, std::chrono::steady_clock::time_point now) {
    return std::chrono::duration<double>(now - then).count();
}

/// The part of the line that is about all runs and levels.
std::string whole_text(const Standing &standing) {
    std::string text;
    if (standing.runs > 1)
        text += ", " + to_text(standing.runs_done) + " of " + to_text(standing.runs) + " runs at " +
                to_text(standing.level) + " generations";
    text += ", " + to_fixed(standing.rate, standing.rate < 10 ? 1 : 0) + " evaluations/s, " +
            duration_text(standing.seconds_left_level) + " left";
    if (standing.levels_left > 0) text += " (all levels: " + duration_text(standing.seconds_left) + ")";
    return text;
}

} // namespace

Progress::Progress(std::ostream &out, bool terminal, std::int64_t evaluations,
                   std::function<void(const Standing &)> share)
    : out_(out), terminal_(terminal), share_(std::move(share)), planned_(evaluations),
      planned_level_(evaluations) {}

Progress::~Progress() { clear_line(); }

void Progress::begin_level(int level, int levels_left, int runs, int runs_done, std::int64_t evaluations) {
    const std::lock_guard lock(mutex_);
    level_ = level, levels_left_ = levels_left;
    runs_ = runs, runs_done_ = runs_done;
    planned_level_ = evaluations;
    done_level_ = 0;
    shared_ = Clock::now();
    share_(standing(shared_));
}

void Progress::reach() {
    const std::lock_guard lock(mutex_);
    ++runs_done_;
}

void Progress::open(int runs) {
    const std::lock_guard lock(mutex_);
    open_ += runs;
}

void Progress::skip(std::int64_t evaluations) {
    const std::lock_guard lock(mutex_);
    planned_ -= evaluations;
    planned_level_ -= evaluations;
}

// The time left assumes that the remaining evaluations take as long as those before.
Standing Progress::standing(Clock::time_point now) const {
    Standing standing{.level = level_,
                      .levels_left = levels_left_,
                      .runs = runs_,
                      .runs_done = runs_done_,
                      .evaluations = done_};
    const double seconds = seconds_from(start_, now);
    if (seconds <= 0 || done_ == 0) return standing;
    standing.rate = static_cast<double>(done_) / seconds;
    standing.seconds_left_level = static_cast<double>(planned_level_ - done_level_) / standing.rate;
    standing.seconds_left = static_cast<double>(planned_ - done_) / standing.rate;
    return standing;
}

void Progress::generation(const std::string &run, int number, int generations, double best, int evaluations) {
    const std::lock_guard lock(mutex_);
    done_ += evaluations;
    done_level_ += evaluations;
    const Clock::time_point now = Clock::now();
    if (seconds_from(shared_, now) >= seconds_between_shares) {
        shared_ = now;
        share_(standing(now));
    }
    if (seconds_from(shown_, now) < (terminal_ ? seconds_between_rewrites : seconds_between_lines)) return;
    shown_ = now;
    const std::string others = open_ > 1 ? " (" + to_text(open_) + " runs at once)" : "";
    const std::string text = run + ": generation " + to_text(number + 1) + " of " + to_text(generations) +
                             ", best " + to_fixed(best, 2) + others + whole_text(standing(now));
    if (terminal_)
        out_ << "\r\x1b[K" << text << std::flush;
    else
        out_ << text << std::endl;
    on_line_ = terminal_;
}

void Progress::tell(const std::string &line) {
    const std::lock_guard lock(mutex_);
    clear_line();
    out_ << line << std::endl;
}

void Progress::clear_line() {
    if (on_line_) out_ << "\r\x1b[K" << std::flush;
    on_line_ = false;
}

std::string duration_text(double seconds) {
    const auto whole = static_cast<std::int64_t>(seconds < 1e9 ? seconds + 0.5 : 1e9);
    if (whole < 60) return to_text(whole) + " s";
    if (whole < 3600) return to_text(whole / 60) + " min " + to_text(whole % 60) + " s";
    return to_text(whole / 3600) + " h " + to_text(whole / 60 % 60) + " min";
}

} // namespace planula
