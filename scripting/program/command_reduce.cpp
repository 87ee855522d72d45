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
    {"runs", "DIR", "where the runs are (default: build/runs/<experiment>)"},
    {"out", "DIR", "where the tables go (default: build/data)"},
    chosen_seeds_option,
    generations_option,
    population_option,
    set_option,
    threads_option,
};
constexpr auto reduce_options = std::span(witness_options).first<6>(); // on one thread

constexpr Option frames_options[] = {
    {"data", "DIR", "where best_genomes.csv is (default: build/data)"},
    {"out", "DIR", "where the frame tables go (default: build/frames)"},
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
    static const Command command{"reduce",
                                 "FILE.lua",
                                 "turns runs into tidy tables: curves, end points, entropies, claims",
                                 "Reads the runs below --runs that are this experiment's and have at least "
                                 "its generations, as they were after "
                                 "these\n(--generations 400 shows runs of 800 as they were at 400), says "
                                 "which folders it leaves out and why, and "
                                 "writes CSV\ntables, the manifest last; planula columns explains every "
                                 "column. Claims whose data are not all there "
                                 "stay open.",
                                 reduce_options,
                                 reduce_runs};
    return command;
}

const Command &frames_command() {
    static const Command command{"frames",
                                 "FILE.lua",
                                 "lives the best individual of each setting again and writes its frames",
                                 "Takes the genomes from best_genomes.csv, which planula reduce wrote, and "
                                 "refuses them if they do not live as\n"
                                 "recorded there.",
                                 frames_options,
                                 make_frames};
    return command;
}

const Command &witness_command() {
    static const Command command{
        "witness",
        "FILE.lua",
        "lives the champion of every run again at finer time steps and in Bullet",
        "Reads the runs as planula reduce does and writes witness.csv, a row for each "
        "champion, and\n"
        "engines.csv, a row for each setting. A champion whose distance changes by more than the parameter\n"
        "exploit_bound at half the step is flagged as an integration exploit, one that stirs on while its "
        "muscles\nhold still as perpetual motion; one that does not live as recorded is refused.",
        witness_options,
        call_witness};
    return command;
}

} // namespace planula
