// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"
#include "analysis/witness.h"
#include "base/text.h"
#include "program/commands.h"

#include <ostream>
#include <span>

namespace planula {

namespace {

constexpr Option witness_options[] = {
    {"runs", "DIR", "folder of the runs (default: build/runs/<experiment>)"},
    {"out", "DIR", "folder for the tables (default: build/data)"},
    chosen_seeds_option,
    generations_option,
    population_option,
    set_option,
    threads_option,
};
constexpr auto reduce_options = std::span(witness_options).first<6>(); // on one thread

constexpr Option frames_options[] = {
    {"data", "DIR", "folder of best_genomes.csv (default: build/data)"},
    {"out", "DIR", "folder for the tables of frames (default: build/frames)"},
    set_option,
};

int reduce_runs(const Arguments &arguments, Console &console) {
    const Experiment experiment = experiment_of(arguments, console);
    const std::string out = arguments.text("out", "build/data");
    reduce(experiment.analysis, experiment.settings, choice_of(arguments, experiment, console), out);
    console.out << out << '\n';
    return 0;
}

int call_witness(const Arguments &arguments, Console &console) {
    const Experiment experiment = experiment_of(arguments, console);
    const std::string out = arguments.text("out", "build/data");
    witness(experiment.settings, choice_of(arguments, experiment, console), out, threads_of(arguments));
    console.out << out << '\n';
    return 0;
}

int make_frames(const Arguments &arguments, Console &console) {
    const Experiment experiment = experiment_of(arguments, console);
    const std::string out = arguments.text("out", "build/frames");
    write_frames(experiment.settings, arguments.text("data", "build/data"), out);
    console.out << out << '\n';
    return 0;
}

} // namespace

const Command &reduce_command() {
    static const Command command{
        "reduce",
        "FILE.lua",
        "computes tables from runs: curves, end points, entropies, claims, and those of the script",
        R"(Reads the runs in the folder --runs that belong to this experiment and have at least its generations, as they were at
that length: --generations 400 shows runs of 800 generations as they were at 400. Reports each folder that is left
out, and why.

Writes CSV tables, manifest.csv last; planula columns explains them. Claims are judged, and tables of the script's own
made, by its functions of the runs. While data for them are missing, a claim stays open and a table is left out.)",
        reduce_options,
        reduce_runs};
    return command;
}

const Command &frames_command() {
    static const Command command{
        "frames",
        "FILE.lua",
        "simulates the best individuals of each setting and writes their frames",
        R"(Reads the genomes from best_genomes.csv, which planula reduce writes. If an individual does not move as recorded
there, the command ends with an error.)",
        frames_options,
        make_frames};
    return command;
}

const Command &witness_command() {
    static const Command command{
        "witness",
        "FILE.lua",
        "simulates the champion of every run at finer time steps and in Bullet",
        R"(Reads the runs as planula reduce does. Writes witness.csv, a row for each champion, and engines.csv, a row
for each setting; planula columns explains them.

A champion whose displacement at half the time step differs by more than the parameter exploit_bound is marked as an
integration exploit. One whose body keeps moving while its muscles are held still is marked as perpetual motion. If a
champion does not move as recorded, the command ends with an error.)",
        witness_options,
        call_witness};
    return command;
}

} // namespace planula
