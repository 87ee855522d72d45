// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/parallel.h"
#include "base/text.h"
#include "experiment/run.h"
#include "record/run_writer.h"
#include "scripting/commands.h"
#include "scripting/interrupt.h"
#include "scripting/progress.h"

#include <algorithm>
#include <optional>
#include <ostream>

namespace planula {

namespace {

constexpr Option options[] = {
    {"seeds", "A:B|N", "seeds A to B, or the one seed N (default: 1 to the parameter `seeds`)"},
    generations_option,
    population_option,
    threads_option,
    lanes_option,
    set_option,
    {"only", "SETTING", "this setting and no other; may be repeated", true},
    {"out", "DIR", "where the runs go (default: build/runs/<experiment>)"},
    {"checkpoint", "N", "generations between two checkpoints of a run (default: 10)"},
};

// One run that the command asks for.
struct Task {
    std::size_t setting;
    std::uint64_t seed;
};

// How much the memo spared, of the generations of this process.
struct LivesKnown {
    std::int64_t asked = 0, lives = 0, movements = 0;

    void add(const Generation &generation) {
        asked += static_cast<std::int64_t>(generation.lives.size());
        lives += generation.known.lives;
        movements += generation.known.movements;
    }
    std::string text() const {
        const double share = 100.0 * static_cast<double>(lives + movements) / static_cast<double>(asked);
        return to_fixed(share, 1) + " % known before (" + to_text(lives) + " lives, " + to_text(movements) +
               " movements)";
    }
};

std::vector<std::size_t> chosen_settings(const Arguments &arguments, const Experiment &experiment) {
    std::vector<std::string> names;
    for (const Spec &setting : experiment.settings) names.push_back(setting.name);
    const std::vector<std::string> only = arguments.all("only");
    for (const std::string &name : only) {
        if (experiment.find(name)) continue;
        const std::string nearest = nearest_name(name, names);
        throw UsageError("--only " + name + ": the experiment has no such setting" +
                         (nearest.empty() ? "" : "; did you mean '" + nearest + "'?"));
    }
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (only.empty() || std::find(only.begin(), only.end(), names[i]) != only.end()) chosen.push_back(i);
    return chosen;
}

class RunCommand {
  public:
    RunCommand(const Arguments &arguments, Console &console)
        : console_(console), experiment_(experiment_of(arguments, console)), crew_(threads_of(arguments)),
          interval_(arguments.whole("checkpoint", 1, RunWriter::usual_interval)),
          out_(runs_folder(arguments, "out", experiment_)), seeds_(seeds_of(arguments, experiment_)),
          settings_(chosen_settings(arguments, experiment_)) {
        use_lanes_of(arguments);
        for (const Spec &setting : experiment_.settings)
            identities_.push_back(identity_of(experiment_, setting));
    }

    int run() {
        const std::vector<Task> tasks = open_tasks();
        std::int64_t evaluations = 0;
        for (const Task &task : tasks) evaluations += evaluations_of(experiment_.settings[task.setting]);
        const Interrupt interrupt;
        Progress progress(console_.err, console_.terminal, evaluations);
        try {
            crew_.work(static_cast<int>(tasks.size()), [&](int job) {
                run_task(tasks[job], {crew_, job}, interrupt, progress);
            });
        } catch (const Stopped &) {
            throw Stopped("stopped; what was done is kept, and the same command goes on");
        }
        progress.tell(to_text(static_cast<std::int64_t>(tasks.size())) + " runs done, in " + out_.string());
        return 0;
    }

  private:
    static std::int64_t evaluations_of(const Spec &setting) {
        return static_cast<std::int64_t>(setting.parameters.population) * setting.parameters.generations;
    }

    // What is still to do: seed by seed, so that an interrupted command leaves all settings alike.
    std::vector<Task> open_tasks() {
        std::vector<Task> tasks;
        for (const std::uint64_t seed : seeds_)
            for (const std::size_t i : settings_) {
                const Spec &setting = experiment_.settings[i];
                const auto folder = run_folder(out_, setting.name, seed);
                if (!is_complete(folder, setting, seed, identities_[i])) {
                    tasks.push_back({i, seed});
                    continue;
                }
                console_.err << folder.string() << ": complete already, skipped\n";
                remove_leftovers(folder);
            }
        return tasks;
    }

    // The beginning of a run, or where an earlier process left it.
    static RunState start(const OwnSetting &setting, const std::string &name, std::uint64_t seed,
                          RunWriter &writer, const Workers &workers, const StopRequest &stop,
                          Progress &progress) {
        for (const std::filesystem::path &path : writer.damaged())
            progress.tell(path.string() + ": damaged, passed over");
        std::optional<RunState> left = writer.take_state();
        if (!left) return begin(setting.spec, seed, workers, stop);
        setting.hooks->continue_run(writer.memory());
        const int done = left->population.generation;
        progress.skip(std::int64_t{done} * setting.spec.parameters.population);
        progress.tell(name + ": goes on with generation " + to_text(done + 1) + " of " +
                      to_text(setting.spec.parameters.generations));
        return std::move(*left);
    }

    // Shares nothing with other runs but the crew, the progress and the texts of the scripts.
    void run_task(const Task &task, const Workers &workers, const Interrupt &interrupt, Progress &progress) {
        const OwnSetting setting = own_setting(experiment_, task.setting);
        const Spec &spec = setting.spec;
        Hooks &hooks = *setting.hooks;
        const std::string name = spec.name + " seed " + to_text(static_cast<std::int64_t>(task.seed));
        const StopRequest stop = [&] { return interrupt.requested() || crew_.failed(); };
        RunWriter writer(run_folder(out_, spec.name, task.seed), spec, task.seed, identities_[task.setting],
                         interval_);
        const Progress::Open open(progress);
        RunState state = start(setting, name, task.seed, writer, workers, stop, progress);
        LivesKnown known;
        const auto observe = [&](const Generation &generation) {
            writer.observe(generation);
            known.add(generation);
            progress.generation(name, generation.number, spec.parameters.generations, writer.best_fitness(),
                                static_cast<int>(generation.lives.size()));
        };
        try {
            planula::run(
                spec, task.seed, workers, state, observe,
                [&](const RunState &now) { writer.between(now, hooks.memory()); }, stop);
        } catch (const Stopped &) {
            writer.keep(state, hooks.memory());
            throw;
        }
        hooks.check_unchanged();
        writer.finish();
        progress.tell(name + ": done, best " + to_fixed(writer.best_fitness(), 2) + ", " + known.text());
        if (hooks.invalid() > 0)
            progress.tell(name + ": " + to_text(hooks.invalid()) +
                          " individuals count as not valid, the first because: " + hooks.first_problem());
    }

    Console &console_;
    const Experiment experiment_;
    Crew crew_;
    const int interval_;
    const std::filesystem::path out_;
    const std::vector<std::uint64_t> seeds_;
    const std::vector<std::size_t> settings_;
    std::vector<RunIdentity> identities_; // per setting
};

int run_runs(const Arguments &arguments, Console &console) { return RunCommand(arguments, console).run(); }

} // namespace

const Command &run_command() {
    static const Command command{
        "run",
        "FILE.lua",
        "runs every setting of an experiment, for every seed",
        "Each run goes to DIR/<setting>/seed-NNN/: the script, tables, and last a "
        "manifest. A run that is complete\n"
        "with the same script, parameters, seed and version is skipped, and one that "
        "was stopped (Ctrl-C, exit\n"
        "code 75) or killed goes on from its last checkpoint: repeat the command. Where one run leaves a "
        "thread idle,\nthe next begins. Results depend on the script, its parameters and the seed alone.",
        options,
        run_runs};
    return command;
}

} // namespace planula
