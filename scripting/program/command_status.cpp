// SPDX-License-Identifier: MIT
#include "base/json.h"
#include "base/text.h"
#include "program/commands.h"
#include "program/progress.h"
#include "program/progress_file.h"
#include "record/run_reader.h"

#include <algorithm>
#include <map>
#include <ostream>

namespace planula {

namespace {

constexpr Option options[] = {
    {"json", "", "print JSON"},
    {"runs", "", "also print a line for each run"},
};

/// The state of all runs below a folder.
struct Overview {
    std::vector<RunStatus> runs;
    std::map<int, int> complete; // runs by the generations that are complete
    int unfinished = 0, unreadable = 0;
    std::int64_t evaluations = 0; // of complete generations and of those up to the checkpoint
    std::uintmax_t bytes = 0;
    std::vector<ProgressRow> processes;
    double rate = 0, seconds_left_level = 0, seconds_left = 0;
};

int done_in(const RunStatus &run) { return std::max(run.complete, run.kept); }

Overview overview_of(const std::filesystem::path &folder) {
    Overview all;
    all.runs = statuses(folder);
    for (const RunStatus &run : all.runs) {
        ++all.complete[run.complete];
        all.unfinished += run.kept > run.complete;
        all.unreadable += !run.trouble.empty();
        all.evaluations += std::int64_t{done_in(run)} * run.population;
        all.bytes += run.bytes;
    }
    all.processes = read_progress(folder);
    // Processes work at the same time: the slowest determines the time left.
    for (const ProgressRow &row : all.processes) {
        all.rate += row.rate;
        all.seconds_left_level = std::max(all.seconds_left_level, row.seconds_left_level);
        all.seconds_left = std::max(all.seconds_left, row.seconds_left);
    }
    return all;
}

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

void print_text(const Overview &all, bool each, std::ostream &out) {
    for (const RunStatus &run : all.runs)
        if (each || !run.trouble.empty()) out << run.folder.string() << ": " << text_of(run) << '\n';
    if (all.runs.empty()) out << "no run (<setting>/seed-NNN) in this folder\n";
    out << all.runs.size() << " runs, " << size_text(all.bytes) << ", " << all.evaluations
        << " evaluations\n";
    for (const auto &[generations, runs] : all.complete)
        out << "  " << runs
            << (generations > 0 ? " with " + to_text(generations) + " generations complete"
                                : std::string(" without complete generations"))
            << '\n';
    out << "  " << all.unfinished << " unfinished\n";
    if (all.unreadable > 0) out << "  " << all.unreadable << " that cannot be read\n";
    if (all.processes.empty()) {
        out << "no process is working on them\n";
        return;
    }
    for (const ProgressRow &row : all.processes)
        out << "a process runs " << row.runs << " runs to generation " << row.level << "; " << row.runs_done
            << " are done\n";
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

int print_status(const Arguments &arguments, Console &console) {
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
generations, how many are unfinished, and, while processes work on them, their speed and the time left.)",
        options,
        print_status};
    return command;
}

} // namespace planula
