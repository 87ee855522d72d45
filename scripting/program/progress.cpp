// SPDX-License-Identifier: MIT
#include "program/progress.h"

#include "base/text.h"

#include <algorithm>
#include <ostream>

namespace planula {

namespace {

constexpr double seconds_between_lines = 10;     // without a terminal
constexpr double seconds_between_rewrites = 0.2; // on a terminal
constexpr double seconds_between_shares = 5;

/// The part of the line that is about all runs and levels.
std::string whole_text(const Standing &standing) {
    std::string text;
    if (standing.runs > 1)
        text += "; " + to_text(standing.runs_done) + " of " + to_text(standing.runs) + " runs done, level " +
                to_text(standing.level);
    if (!(standing.rate > 0)) return text + "; time left not known yet";
    text += "; " + to_fixed(standing.rate, standing.rate < 10 ? 1 : 0) + " evaluations/s, " +
            duration_text(standing.seconds_left_level) + " left";
    if (standing.levels_left > 0) text += " (all levels: " + duration_text(standing.seconds_left) + ")";
    return text;
}

std::string text_of(const GenerationReport &report) {
    return report.run + ": generation " + to_text(report.number + 1) + " of " + to_text(report.generations) +
           ", best " + to_fixed(report.best, 2) + (report.unit.empty() ? "" : " " + report.unit) + ", " +
           to_fixed(100 * report.viable, 0) + " % viable";
}

void subtract(Workload &left, const std::string &setting, int evaluations) {
    if (const auto own = left.find(setting); own != left.end())
        own->second = std::max<std::int64_t>(0, own->second - evaluations);
}

} // namespace

std::string fitness_unit(const Spec &setting) {
    for (const FunctionMeaning &function : setting.judgement)
        if (function.name == "fitness" &&
            ("/" + function.place).find("/paper/judgement.lua:") != std::string::npos)
            return "cell diameters";
    return "";
}

GenerationReport report_of(const Spec &setting, const std::string &run, const Generation &generation,
                           double best) {
    const auto viable = std::count_if(generation.lives.begin(), generation.lives.end(),
                                      [](const Life &life) { return life.outcome == Outcome::viable; });
    const auto lives = static_cast<int>(generation.lives.size());
    return {.setting = setting.name,
            .run = run,
            .number = generation.number,
            .generations = setting.parameters.design.generations,
            .best = best,
            .unit = fitness_unit(setting),
            .viable = static_cast<double>(viable) / lives,
            .evaluations = lives};
}

Progress::Progress(std::ostream &out, bool terminal, Workload planned,
                   std::function<void(const Standing &)> share)
    : out_(out), terminal_(terminal), share_(std::move(share)), planned_(std::move(planned)),
      planned_level_(planned_) {}

Progress::~Progress() { clear_line(); }

double Progress::seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }

void Progress::begin_level(int level, int levels_left, int runs, int runs_done, Workload planned_level,
                           Workload planned) {
    const std::lock_guard lock(mutex_);
    level_ = level, levels_left_ = levels_left;
    runs_ = runs, runs_done_ = runs_done;
    planned_level_ = std::move(planned_level);
    planned_ = std::move(planned);
    shared_ = seconds();
    share_(standing());
}

void Progress::reach() {
    const std::lock_guard lock(mutex_);
    ++runs_done_;
}

Progress::Open::Open(Progress &progress) : progress_(progress) {
    const std::lock_guard lock(progress_.mutex_);
    ++progress_.open_;
    progress_.left_.open(progress_.seconds());
}

Progress::Open::~Open() {
    const std::lock_guard lock(progress_.mutex_);
    --progress_.open_;
    progress_.left_.close(progress_.seconds());
}

void Progress::Open::measure(const std::function<void()> &task) {
    const Clock::time_point began = Clock::now();
    task();
    busy_ += std::chrono::nanoseconds(Clock::now() - began).count();
}

double Progress::Open::take_busy() {
    return std::chrono::duration<double>(std::chrono::nanoseconds(busy_.exchange(0))).count();
}

Standing Progress::standing() const {
    return {.level = level_,
            .levels_left = levels_left_,
            .runs = runs_,
            .runs_done = runs_done_,
            .evaluations = done_,
            .rate = left_.rate(),
            .seconds_left_level = left_.seconds(planned_level_),
            .seconds_left = left_.seconds(planned_)};
}

void Progress::generation(const GenerationReport &report) {
    const std::lock_guard lock(mutex_);
    const double now = seconds();
    done_ += report.evaluations;
    subtract(planned_, report.setting, report.evaluations);
    subtract(planned_level_, report.setting, report.evaluations);
    left_.done(report.setting, report.evaluations, report.busy > 0 ? report.busy : now - reported_, now);
    reported_ = now;
    if (now - shared_ >= seconds_between_shares) {
        shared_ = now;
        share_(standing());
    }
    if (now - shown_ < (terminal_ ? seconds_between_rewrites : seconds_between_lines)) return;
    shown_ = now;
    const std::string others = open_ > 1 ? " (" + to_text(open_) + " runs at once)" : "";
    const std::string text = text_of(report) + others + whole_text(standing());
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
