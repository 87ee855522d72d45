// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"
#include "base/error.h"
#include "page/page.h"
#include "program/commands.h"
#include "report/report_page.h"
#include "statement/recorded.h"
#include "storage/output.h"

#include <ostream>

namespace planula {

namespace {

constexpr Option options[] = {
    {"script", "FILE.lua",
     "take title, settings and claims from this script (default: from the one that the first run keeps)"},
    {"out", "DIR", "folder for report.html and its tables (default: build/report/<experiment>)"},
    {"generations", "N",
     "show the runs as they were after N generations (default: as many as all runs of a setting have)"},
    chosen_seeds_option,
    threads_option,
    {"module", "FILE",
     "let the page simulate its champions again, by the module that `make wasm` builds: "
     "build/wasm/planula.js"},
};

/// The experiment as its script states it, or the first run keeps it.
Experiment stated_experiment(const Arguments &arguments, const ReportRuns &runs, const Console &console) {
    if (arguments.has("script")) return load_experiment(arguments.text("script"), console.library);
    try {
        return recorded_experiment(runs.runs.front().folder);
    } catch (const InputError &error) {
        throw InputError(std::string(error.what()) +
                         "\nthe run keeps a script that this version of planula does not accept; name the "
                         "experiment's present one by --script FILE.lua");
    }
}

/// The same with the settings that have runs here, each with the generations that are shown.
Experiment reported_experiment(const Arguments &arguments, const ReportRuns &runs, const Console &console) {
    Experiment experiment = stated_experiment(arguments, runs, console);
    keep_settings(experiment, runs.settings);
    if (experiment.settings.empty())
        throw InputError(arguments.text("script") + " has no setting '" + runs.settings.front() +
                         "', which the runs in " + arguments.operands.at(0) + " are of");
    ask_common_generations(experiment, runs.runs);
    if (arguments.has("generations"))
        for (Spec &setting : experiment.settings)
            setting.parameters.design.generations = arguments.whole("generations", 1, 1);
    return experiment;
}

int make_report(const Arguments &arguments, Console &console) {
    const ReportBundle bundle = read_bundle(console.bundle);
    const std::string module = arguments.has("module") ? packed_module(arguments.text("module")) : "";
    ReportRuns runs = report_runs(arguments.operands.at(0));
    const Experiment experiment = reported_experiment(arguments, runs, console);
    if (arguments.has("seeds")) runs.choice.seeds = seeds_of(arguments, experiment);
    std::vector<std::string> told;
    runs.choice.tell = [&](const std::string &line) {
        console.err << line << '\n';
        told.push_back(line);
    };
    const std::filesystem::path out = arguments.text("out", "build/report/" + experiment.name);
    reduce(experiment.analysis, experiment.settings, runs.choice, out);

    const ReportSources sources{experiment, runs, out, console.library, told};
    const std::filesystem::path page = out / "report.html";
    write_file(page, report_page(sources, bundle, report_data(sources),
                                 champion_recordings(sources, threads_of(arguments)), module));
    console.out << page.string() << '\n';
    return 0;
}

} // namespace

const Command &report_command() {
    static const Command command{
        "report",
        "DIR",
        "makes a page of what runs have come to, for a browser without a network",
        R"(DIR is a folder of runs: that of one run, of one setting, or of all runs of an experiment. Writes the tables of planula
reduce, and report.html, a page that needs no other file and no network: what was asked and what is missing, curves,
searches side by side, where individuals ended, species, archive, sizes, heredity, claims with their verdicts,
parameters and departures from the paper, and the champion of every run, which grows and moves. A champion that does
not move as recorded is an error.

The scripts of the page are bundled once by `make report`. With --module, which `make report WASM=1` gives, the page also
simulates a champion again where the reader asks for it, and shows whether the life is that of the record.)",
        options,
        make_report};
    return command;
}

} // namespace planula
