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

void Progress::begin(std::string run, int generations) {
    run_ = std::move(run);
    generations_ = generations;
}

void Progress::generation(int number, double best, int evaluations) {
    done_ += evaluations;
    const Clock::time_point now = Clock::now();
    const double since_shown = std::chrono::duration<double>(now - shown_).count();
    if (since_shown < (terminal_ ? seconds_between_rewrites : seconds_between_lines)) return;
    shown_ = now;

    // The time left assumes that what is left costs as much as what is done.
    const double rate = static_cast<double>(done_) / std::chrono::duration<double>(now - start_).count();
    const std::string text = run_ + ": generation " + to_text(number + 1) + " of " + to_text(generations_) +
                             ", best " + to_fixed(best, 2) + ", " + to_fixed(rate, rate < 10 ? 1 : 0) +
                             " evaluations/s, " +
                             duration_text(static_cast<double>(planned_ - done_) / rate) + " left";
    if (terminal_)
        out_ << "\r\x1b[K" << text << std::flush;
    else
        out_ << text << std::endl;
    on_line_ = terminal_;
}

void Progress::tell(const std::string &line) {
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
