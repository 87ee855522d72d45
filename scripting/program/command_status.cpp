// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/json.h"
#include "base/text.h"
#include "program/commands.h"
#include "program/interrupt.h"
#include "program/overview.h"
#include "program/progress.h"
#include "program/status_page.h"
#include "storage/output.h"

#include <algorithm>
#include <ctime>
#include <map>
#include <ostream>

#include <unistd.h>

namespace planula {

namespace {

constexpr Option options[] = {
    {"json", "", "print JSON"},
    {"runs", "", "also print a line for each run"},
    {"page", "FILE", "write a page for a browser, with the curves of all runs"},
    {"every", "SECONDS", "with --page: write it again and again until no process works on the runs"},
};

std::string size_text(std::uintmax_t bytes) {
    constexpr double megabyte = 1e6, gigabyte = 1e9;
    const auto size = static_cast<double>(bytes);
    return size < gigabyte ? to_fixed(size / megabyte, 1) + " MB" : to_fixed(size / gigabyte, 2) + " GB";
}

std::string text_of(const RunStatus &run) {
    if (!run.trouble.empty()) return run.trouble;
    std::string text =
        run.complete > 0 ? to_text(run.complete) + " generations complete" : "no generations complete";
    if (run.kept > run.complete) text += ", " + to_text(run.kept) + " saved in a checkpoint";
    return text + ", " + size_text(run.bytes);
}

std::string with_generations(int least, int most, const char *what) {
    return " with " + to_text(least) + (most > least ? " to " + to_text(most) : "") + " generations " + what;
}

/// How many runs are how far; each is counted in one line.
void print_counts(const Overview &all, std::ostream &out) {
    std::map<int, int> complete;
    int least = 0, most = 0;
    for (const RunStatus &run : all.runs) {
        if (run.kept > run.complete) {
            least = least == 0 ? run.kept : std::min(least, run.kept);
            most = std::max(most, run.kept);
        } else if (run.trouble.empty())
            ++complete[run.complete];
    }
    for (const auto &[generations, runs] : complete)
        out << "  " << runs
            << (generations > 0 ? with_generations(generations, generations, "complete")
                                : std::string(" without a saved generation"))
            << '\n';
    if (all.unfinished > 0)
        out << "  " << all.unfinished << " unfinished," << with_generations(least, most, "saved") << '\n';
    if (all.unreadable > 0) out << "  " << all.unreadable << " that cannot be read\n";
}

void print_text(const Overview &all, bool each, std::ostream &out) {
    for (const RunStatus &run : all.runs)
        if (each || !run.trouble.empty()) out << run.folder.string() << ": " << text_of(run) << '\n';
    if (all.runs.empty()) out << "no run (<setting>/seed-NNN) in this folder or below it\n";
    out << counted(all.runs.size(), "run") << ", " << size_text(all.bytes) << ", " << all.evaluations
        << " evaluations\n";
    print_counts(all, out);
    if (all.processes.empty()) {
        out << "no process is working on them\n";
        return;
    }
    for (const ProgressRow &row : all.processes)
        out << "a process runs " << counted(row.runs, "run") << " to generation " << row.level << "; "
            << row.runs_done << " are done\n";
    if (!(all.rate > 0)) {
        out << "the speed is not known yet\n";
        return;
    }
    out << to_fixed(all.rate, all.rate < 10 ? 1 : 0) << " evaluations/s, "
        << duration_text(all.seconds_left_level) << " left for this level, "
        << duration_text(all.seconds_left) << " for all levels\n";
}

/// A time in JSON, which is unknown until there is a rate.
std::string seconds_text(double seconds, double rate) { return rate > 0 ? to_text(seconds) : "null"; }

void print_json(const Overview &all, std::ostream &out) {
    out << "{\n  \"runs\": [";
    const char *separator = "\n";
    for (const RunStatus &run : all.runs) {
        out << separator << "    {\"folder\": " << json_text(run.folder.string())
            << ", \"complete\": " << run.complete << ", \"kept\": " << run.kept
            << ", \"population\": " << run.population << ", \"bytes\": " << run.bytes
            << ", \"trouble\": " << json_text(run.trouble) << '}';
        separator = ",\n";
    }
    out << "\n  ],\n  \"complete\": [";
    separator = "";
    for (const auto &[generations, runs] : all.complete) {
        out << separator << "{\"generations\": " << generations << ", \"runs\": " << runs << '}';
        separator = ", ";
    }
    out << "],\n  \"under_way\": " << all.unfinished << ",\n  \"evaluations\": " << all.evaluations
        << ",\n  \"bytes\": " << all.bytes << ",\n  \"processes\": [";
    separator = "";
    for (const ProgressRow &row : all.processes) {
        out << separator << "{\"level\": " << row.level << ", \"runs\": " << row.runs
            << ", \"runs_done\": " << row.runs_done << ", \"rate\": " << to_text(row.rate)
            << ", \"seconds_left_level\": " << seconds_text(row.seconds_left_level, row.rate)
            << ", \"seconds_left\": " << seconds_text(row.seconds_left, row.rate) << '}';
        separator = ", ";
    }
    out << "],\n  \"rate\": " << to_text(all.rate)
        << ",\n  \"seconds_left_level\": " << seconds_text(all.seconds_left_level, all.rate)
        << ",\n  \"seconds_left\": " << seconds_text(all.seconds_left, all.rate) << "\n}\n";
}

/// The time of this machine, without its zone's name, which may be anything.
std::string time_text() {
    const std::time_t now = std::time(nullptr);
    std::tm parts{};
    ::localtime_r(&now, &parts);
    const auto two = [](int number) { return (number < 10 ? "0" : "") + to_text(number); };
    return to_text(1900 + parts.tm_year) + "-" + two(parts.tm_mon + 1) + "-" + two(parts.tm_mday) + " " +
           two(parts.tm_hour) + ":" + two(parts.tm_min) + ":" + two(parts.tm_sec);
}

/// Writes the page once, or until no process works on the runs or the user stops it. The last one stays as it is.
int write_pages(const Arguments &arguments, Console &console) {
    const std::filesystem::path folder = arguments.operands.at(0), file = arguments.text("page");
    const int every = arguments.whole("every", 1, 0);
    const Interrupt interrupt;
    Words words;
    for (bool goes_on = true; goes_on;) {
        const Overview all = overview_of(folder);
        words = words_of(all, std::move(words));
        goes_on = every > 0 && !all.processes.empty() && !interrupt.requested();
        write_file(file, status_page(all, curves_of(all), words, time_text(), goes_on ? every : 0));
        for (int second = 0; goes_on && second < every && !interrupt.requested(); ++second) ::sleep(1);
    }
    console.out << file.string() << '\n';
    return 0;
}

int print_status(const Arguments &arguments, Console &console) {
    if (arguments.has("page")) return write_pages(arguments, console);
    if (arguments.has("every")) throw UsageError("--every belongs to --page, which is not given");
    const Overview all = overview_of(arguments.operands.at(0));
    if (arguments.has("json"))
        print_json(all, console.out);
    else
        print_text(all, arguments.has("runs"), console.out);
    return 0;
}

} // namespace

const Command &status_command() {
    static const Command command{
        "status",
        "DIR",
        "reports how far the runs in a folder are, and their size on disk",
        R"(DIR is the folder that was given to planula run as --out. Reports how many runs have completed how many
generations, how many are unfinished, and, while processes work on them, their speed and the time left.

--page writes one HTML file that needs nothing else: open it in a browser. With --every it is written again until the
runs end or Ctrl-C, and the browser loads it again by itself. It shows what the runs have saved, by default every
tenth generation, and never disturbs them.)",
        options,
        print_status};
    return command;
}

} // namespace planula
