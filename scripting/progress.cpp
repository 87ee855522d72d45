// SPDX-License-Identifier: MIT
#include "scripting/progress.h"

#include "base/text.h"

#include <ostream>

namespace planula {

namespace {

constexpr double seconds_between_lines = 10;     // without a terminal
constexpr double seconds_between_rewrites = 0.2; // on a terminal

} // namespace

Progress::Progress(std::ostream &out, bool terminal, std::int64_t evaluations)
    : out_(out), terminal_(terminal), planned_(evaluations) {}

Progress::~Progress() { clear_line(); }

void Progress::open(int runs) {
    const std::lock_guard lock(mutex_);
    open_ += runs;
}

void Progress::skip(std::int64_t evaluations) {
    const std::lock_guard lock(mutex_);
    planned_ -= evaluations;
}

void Progress::generation(const std::string &run, int number, int generations, double best, int evaluations) {
    const std::lock_guard lock(mutex_);
    done_ += evaluations;
    const Clock::time_point now = Clock::now();
    const double since_shown = std::chrono::duration<double>(now - shown_).count();
    if (since_shown < (terminal_ ? seconds_between_rewrites : seconds_between_lines)) return;
    shown_ = now;

    // The time left assumes that what is left costs as much as what is done.
    const double rate = static_cast<double>(done_) / std::chrono::duration<double>(now - start_).count();
    const std::string others = open_ > 1 ? " (" + to_text(open_) + " runs at once)" : "";
    const std::string text = run + ": generation " + to_text(number + 1) + " of " + to_text(generations) +
                             ", best " + to_fixed(best, 2) + others + ", " +
                             to_fixed(rate, rate < 10 ? 1 : 0) + " evaluations/s, " +
                             duration_text(static_cast<double>(planned_ - done_) / rate) + " left";
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
