// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/parallel.h"
#include "base/text.h"
#include "experiment/run.h"
#include "program/commands.h"
#include "program/device_choice.h"
#include "program/forecast.h"
#include "program/interrupt.h"
#include "program/progress.h"
#include "program/progress_file.h"
#include "record/complete_run.h"
#include "record/run_writer.h"

#include <algorithm>
#include <optional>
#include <ostream>

namespace planula {

namespace {

constexpr Option options[] = {
    {"seeds", "A:B|N", "seeds A to B, or only seed N (default: 1 to the parameter seeds)"},
    generations_option,
    {"levels", "N,N,...",
     "bring all runs to the first of these generations, then all to the next, and so on"},
    population_option,
    threads_option,
    lanes_option,
    device_option,
    set_option,
    {"only", "SETTING", "run only this setting; may be repeated", true},
    {"part", "I:N", "run every Nth of all runs, starting with the Ith: the share of one of N machines"},
    {"out", "DIR", "folder for the runs (default: build/runs/<experiment>)"},
    {"checkpoint", "N", "generations between two checkpoints of a run (default: 10)"},
    {"forecast", "",
     "run nothing; measure a few generations and report the time, disk space and memory that all runs take"},
    {"cores", "N", "with --forecast: also report the time on N cores"},
};

// How many evaluations of this process were answered from earlier ones.
struct Reused {
    std::int64_t asked = 0, lives = 0, movements = 0;

    void add(const Generation &generation) {
        asked += static_cast<std::int64_t>(generation.lives.size());
        lives += generation.known.lives;
        movements += generation.known.movements;
    }
    std::string text() const {
        const double share = 100.0 * static_cast<double>(lives + movements) / static_cast<double>(asked);
        return to_fixed(share, 1) + " % of evaluations reused (" + to_text(lives) + " of equal genomes, " +
               to_text(movements) + " of equal bodies)";
    }
};

std::vector<std::size_t> chosen_settings(const Arguments &arguments, const Experiment &experiment) {
    std::vector<std::string> names;
    for (const Spec &setting : experiment.settings) names.push_back(setting.name);
    const std::vector<std::string> only = arguments.all("only");
    for (const std::string &name : only) {
        if (!experiment.find(name))
            throw UsageError("--only " + name + ": the experiment has no setting of this name" +
                             suggestion(name, names));
    }
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (only.empty() || std::find(only.begin(), only.end(), names[i]) != only.end()) chosen.push_back(i);
    return chosen;
}

// --part I:N as the first run, from 0, and the step.
std::pair<std::size_t, std::size_t> part_of(const Arguments &arguments) {
    const std::string words = arguments.text("part", "1:1");
    const std::size_t colon = words.find(':');
    const auto part = parse_int(words.substr(0, colon));
    const auto parts = colon == words.npos ? std::nullopt : parse_int(words.substr(colon + 1));
    if (!part || !parts || *part < 1 || *parts < *part)
        throw UsageError("--part takes I:N with 1 <= I <= N, not '" + words + "'");
    return {static_cast<std::size_t>(*part) - 1, static_cast<std::size_t>(*parts)};
}

class RunCommand {
  public:
    RunCommand(const Arguments &arguments, Console &console)
        : console_(console), device_(arguments), levels_(levels_of(arguments)),
          experiment_(experiment_to_run(arguments, console)), crew_(threads_of(arguments)),
          interval_(arguments.whole("checkpoint", 1, RunWriter::usual_interval)),
          out_(runs_folder(arguments, "out", experiment_)), runs_(runs_of(arguments, experiment_)),
          sources_(sources_of(experiment_)) {
        use_lanes_of(arguments);
        if (levels_.empty()) levels_.push_back(0); // every setting's own length
    }

    int run() {
        check_folders();
        const Interrupt interrupt;
        ProgressFile file(out_);
        Progress progress(console_.err, console_.terminal, {},
                          [&](const Standing &standing) { file.write(standing); });
        try {
            for (std::size_t i = 0; i < levels_.size(); ++i) run_level(i, interrupt, progress);
        } catch (const Stopped &) {
            throw Stopped("stopped; all results so far are saved, and the same command resumes");
        }
        progress.tell(counted(runs_.size(), "run") + " done, in " + out_.string());
        return 0;
    }

  private:
    int generations_of(const PlannedRun &run, int level) const {
        return level > 0 ? level : experiment_.settings[run.setting].parameters.design.generations;
    }
    std::filesystem::path folder_of(const PlannedRun &run) const {
        return run_folder(out_, experiment_.settings[run.setting].name, run.seed);
    }

    // Every folder is checked before anything is written.
    void check_folders() const {
        std::vector<std::string> refused;
        for (const PlannedRun &run : runs_) {
            const Spec &setting = experiment_.settings[run.setting];
            try {
                check_same_run(folder_of(run), {identity_of(setting, run.seed), setting.record});
            } catch (const RefusedError &error) {
                refused.push_back(error.what());
            }
        }
        if (refused.empty()) return;
        throw RefusedError(refused.front() +
                           (refused.size() > 1
                                ? "\n  Of the " + to_text(static_cast<std::int64_t>(runs_.size())) +
                                      " runs asked for, " +
                                      to_text(static_cast<std::int64_t>(refused.size())) +
                                      " have such a folder. Nothing was changed."
                                : "\n  Nothing was changed."));
    }

    // The evaluations that runs lack to a level.
    Workload workload_to(int level) const {
        Workload evaluations;
        for (const PlannedRun &run : runs_) {
            const int lacking = generations_of(run, level) - recorded_generations(folder_of(run));
            const Spec &setting = experiment_.settings[run.setting];
            evaluations[setting.name] +=
                std::int64_t{std::max(0, lacking)} * setting.parameters.neat.population;
        }
        return evaluations;
    }

    bool has_reached(const PlannedRun &run, int level) const {
        return complete_generations(folder_of(run)) >= generations_of(run, level);
    }

    void run_level(std::size_t at, const Interrupt &interrupt, Progress &progress) {
        const int level = levels_[at];
        std::vector<PlannedRun> open;
        for (const PlannedRun &run : runs_)
            if (!has_reached(run, level))
                open.push_back(run);
            else
                tidy_complete_run(folder_of(run));
        const int runs = static_cast<int>(runs_.size()), done = runs - static_cast<int>(open.size());
        progress.begin_level(generations_of(runs_.front(), level), static_cast<int>(levels_.size() - 1 - at),
                             runs, done, workload_to(level), workload_to(levels_.back()));
        if (done > 0)
            progress.tell(to_text(done) + " of " + to_text(runs) + " runs have " +
                          to_text(generations_of(runs_.front(), level)) + " generations already");
        crew_.work(static_cast<int>(open.size()), [&](int job) {
            run_one(open[static_cast<std::size_t>(job)], level, job, interrupt, progress);
        });
    }

    // The state at the beginning of a run, or the one that an earlier process saved.
    static RunState start(const SettingForRun &setting, const std::string &name, std::uint64_t seed,
                          RunWriter &writer, const Workers &workers, const StopRequest &stop,
                          Progress &progress) {
        for (const std::filesystem::path &path : writer.damaged())
            progress.tell(path.string() + ": damaged and ignored");
        std::optional<RunState> saved = writer.take_state();
        if (saved) {
            setting.functions->continue_run(writer.memory());
            progress.tell(name + ": resumes with generation " + to_text(saved->population.generation + 1) +
                          " of " + to_text(writer.generations()));
        }
        RunState state = saved ? std::move(*saved) : begin(setting.spec, seed, workers, stop);
        writer.before_generation(state, setting.functions->memory());
        return state;
    }

    // Shares only the crew, the progress and the sources of the scripts with other runs.
    void run_one(const PlannedRun &run, int level, int job, const Interrupt &interrupt, Progress &progress) {
        SettingForRun setting = setting_for_run(experiment_, run.setting);
        Spec &spec = setting.spec;
        JudgingFunctions &functions = *setting.functions;
        spec.parameters.design.generations = generations_of(run, level);
        const std::string name = spec.name + " seed " + to_text(static_cast<std::int64_t>(run.seed));
        const StopRequest stop = [&] { return interrupt.requested() || crew_.failed(); };
        RunWriter writer(folder_of(run), spec, run.seed, sources_, interval_);
        if (writer.is_complete()) {
            progress.tell(name + ": completed by another process in the meantime");
            progress.reach();
            return;
        }
        spec.parameters.design.generations = writer.generations();
        Progress::Open open(progress);
        const Workers workers(crew_, job, [&](const std::function<void()> &task) { open.measure(task); });
        RunState state = start(setting, name, run.seed, writer, workers, stop, progress);
        Reused reused;
        const auto observe = [&](const Generation &generation) {
            writer.observe(generation);
            reused.add(generation);
            GenerationReport report = report_of(spec, name, generation, writer.best_fitness());
            report.busy = open.take_busy();
            progress.generation(report);
        };
        try {
            planula::run(
                spec, run.seed, workers, state, observe,
                [&](const RunState &now) { writer.before_generation(now, functions.memory()); }, stop);
        } catch (const Stopped &) {
            writer.checkpoint(state, functions.memory());
            throw;
        }
        functions.check_unchanged();
        writer.finish();
        progress.reach();
        progress.tell(name + ": " + to_text(spec.parameters.design.generations) + " generations done, best " +
                      to_fixed(writer.best_fitness(), 2) + ", " + reused.text());
        if (functions.invalid() > 0)
            progress.tell(name + ": " + to_text(functions.invalid()) +
                          " individuals count as invalid; the first because " + functions.first_problem());
    }

    Console &console_;
    const DeviceChoice device_;
    std::vector<int> levels_;
    const Experiment experiment_;
    Crew crew_;
    const int interval_;
    const std::filesystem::path out_;
    const std::vector<PlannedRun> runs_;
    const RunSources sources_;
};

int run_runs(const Arguments &arguments, Console &console) {
    if (arguments.has("forecast")) return forecast(arguments, console);
    return RunCommand(arguments, console).run();
}

} // namespace

std::vector<int> levels_of(const Arguments &arguments) {
    std::vector<int> levels;
    if (!arguments.has("levels")) return levels;
    for (const auto &[name, value] : overrides_of(arguments))
        if (name == "generations")
            throw UsageError("the parameter generations is given twice: --levels states it, too");
    const std::string words = arguments.text("levels");
    for (std::size_t at = 0; at <= words.size();) {
        const std::size_t comma = std::min(words.find(',', at), words.size());
        const auto level = parse_int(words.substr(at, comma - at));
        if (!level || *level < 1 || *level > 10'000'000 || (!levels.empty() && *level <= levels.back()))
            throw UsageError("--levels takes ascending numbers of generations, such as 25,50,100, not '" +
                             words + "'");
        levels.push_back(static_cast<int>(*level));
        at = comma + 1;
    }
    return levels;
}

Experiment experiment_to_run(const Arguments &arguments, const Console &console) {
    const std::vector<int> levels = levels_of(arguments);
    Overrides changes;
    if (!levels.empty()) changes.emplace_back("generations", levels.back());
    return experiment_of(arguments, console, changes);
}

std::vector<PlannedRun> runs_of(const Arguments &arguments, const Experiment &experiment) {
    const std::vector<std::size_t> settings = chosen_settings(arguments, experiment);
    const auto [first, step] = part_of(arguments);
    std::vector<PlannedRun> runs;
    std::size_t number = 0;
    for (const std::uint64_t seed : seeds_of(arguments, experiment))
        for (const std::size_t setting : settings)
            if (number++ % step == first) runs.push_back({setting, seed});
    if (runs.empty())
        throw UsageError("--part " + arguments.text("part") + ": there are " +
                         to_text(static_cast<std::int64_t>(number)) +
                         " runs, so this part is empty; give an N of at most that number");
    return runs;
}

const Command &run_command() {
    static const Command command{"run",
                                 "FILE.lua",
                                 "evolves every setting of an experiment, once for each seed",
                                 R"(The results of each run are written to DIR/<setting>/seed-NNN/.

A run that was stopped (Ctrl-C, exit code 75) or killed resumes from its last checkpoint when the
same command is given again. A complete run with fewer generations than asked for is continued;
its results are the same as if it had never ended. A run that is long enough is left as it is. If a
folder holds a different run or other files, the command ends with exit code 73 and changes nothing.

Results depend only on what identity.csv in the folder of a run lists. They do not depend on the number of
threads, on the machine, or on titles and comments in the script.)",
                                 options,
                                 run_runs};
    return command;
}

} // namespace planula
