// SPDX-License-Identifier: MIT
#include "base/error.h"
#include "base/text.h"
#include "program/commands.h"
#include "program/cost.h"
#include "program/interrupt.h"
#include "statement/departures.h"
#include "statement/specimens.h"
#include "statement/trial_lives.h"
#include "statement/unread.h"

#include <algorithm>
#include <map>
#include <ostream>

namespace planula {

namespace {

constexpr Option check_options[] = {
    {"quick", "", "reads the script only: no trial lives and no estimate"},
    {"strict", "", "warnings are errors: exit code 65"},
    {"seeds", "A:B|N", "seeds to estimate for (default: 1 to the parameter seeds)"},
    generations_option,
    population_option,
    set_option,
    threads_option,
};

// Of many settings each is tried with fewer specimens, so that a check takes seconds.
constexpr std::size_t few_settings = 16;
constexpr std::size_t specimens_of_many = 4;
// Sizes on disk are measured in so small a run.
constexpr int measured_population = 20, measured_generations = 2;

/// Every k-th of them, so that `most` or a few more are left.
std::vector<Genome> thinned(std::vector<Genome> genomes, std::size_t most) {
    const std::size_t step = std::max<std::size_t>(genomes.size() / most, 1);
    std::vector<Genome> left;
    for (std::size_t i = 0; i < genomes.size(); i += step) left.push_back(std::move(genomes[i]));
    return left;
}

/// Trial lives and what they took.
struct Tried {
    TrialLives lives;
    double life_seconds = 0, growth_seconds = 0; // of a processor, for one individual
};

class Check {
  public:
    Check(const Arguments &arguments, Console &console)
        : arguments_(arguments), console_(console), experiment_(experiment_of(arguments, console)),
          threads_(threads_of(arguments)) {}

    int run() {
        Comparison comparison(experiment_, console_.library);
        find_unread(experiment_, comparison.paper(), findings_);
        if (!arguments_.has("quick"))
            for (std::size_t i = 0; i < experiment_.settings.size(); ++i) try_setting(i);
        report();
        tell_experiment();
        if (!arguments_.has("quick")) tell_estimate();
        return 0;
    }

  private:
    bool stop() const { return interrupt_.requested(); }

    const std::vector<Genome> &specimens_for(Actuation actuation) {
        std::vector<Genome> &genomes = specimens_[actuation];
        if (genomes.empty()) genomes = specimens(console_.library, actuation);
        if (experiment_.settings.size() > few_settings && genomes.size() > specimens_of_many)
            genomes = thinned(std::move(genomes), specimens_of_many);
        return genomes;
    }

    // Settings that differ in their search alone share their trial lives.
    const Tried &tried(const Spec &spec) {
        const auto [known, is_new] = tried_.try_emplace(conditions_text(spec));
        Tried &own = known->second;
        const std::vector<Genome> &genomes = specimens_for(spec.actuation);
        const StopRequest stop_now = [&] { return stop(); };
        const auto timed = [&](double &seconds, auto &&simulate) {
            const double began = processor_seconds();
            std::vector<Life> lives = simulate(spec, genomes, threads_, stop_now);
            const double taken = processor_seconds() - began;
            simulated_seconds_ += taken;
            seconds = taken / static_cast<double>(genomes.size());
            return lives;
        };
        if (is_new) own.lives.complete = timed(own.life_seconds, complete_lives);
        if (spec.start && own.lives.grown.empty()) own.lives.grown = timed(own.growth_seconds, grown_lives);
        return own;
    }

    void try_setting(std::size_t index) {
        const Spec &spec = experiment_.settings[index];
        const Tried &own = tried(spec);
        judge_trials(experiment_, index, own.lives, findings_);
        find_idle_numbers(
            experiment_, index, specimens_for(spec.actuation), own.lives, [&] { return stop(); }, findings_);
        lives_ += own.lives.complete.size();
        for (const Life &life : own.lives.complete) viable_ += life.outcome == Outcome::viable;
        const Parameters &p = spec.parameters;
        seconds_ += own.life_seconds * p.neat.population * p.design.generations;
        if (spec.start) seconds_ += own.growth_seconds * p.neat.population * spec.start->generations;
        evaluations_ += static_cast<double>(p.neat.population) * p.design.generations;
    }

    /// Prints warnings; throws InputError with all errors, to which warnings belong if they are to be errors.
    void report() const {
        std::string errors;
        for (const CheckFinding &finding : findings_.all()) {
            const std::string line = line_of(finding, experiment_.settings.size());
            if (finding.is_error || arguments_.has("strict"))
                errors += (errors.empty() ? "" : "\n") + line;
            else
                console_.err << "warning: " << line << '\n';
        }
        if (!errors.empty()) throw InputError(errors);
    }

    void tell_experiment() const {
        console_.out << "ok: " << arguments_.operands[0] << ": " << experiment_.name << ", "
                     << counted(experiment_.settings.size(), "setting") << ':';
        for (const Spec &setting : experiment_.settings) console_.out << ' ' << setting.name;
        console_.out << '\n';
        if (lives_ > 0)
            console_.out << "trial lives: " << viable_ << " of " << lives_
                         << " end viable, of evolved specimens in "
                         << counted(experiment_.settings.size(), "setting") << "; simulated in "
                         << to_fixed(simulated_seconds_, 2) << " s of processor time\n";
    }

    void tell_estimate() {
        double bytes = 0, unfinished = 0;
        for (std::size_t i = 0; i < experiment_.settings.size(); ++i) {
            const Cost cost = cost_of(experiment_.settings[i], measured(i));
            bytes += cost.table_bytes + cost.state_bytes;
            unfinished = std::max(unfinished, cost.journal_bytes);
            archive_ = std::max(archive_, cost.archive_bytes);
        }
        const std::size_t count = seeds_of(arguments_, experiment_).size(),
                          runs = experiment_.settings.size() * count;
        const double seeds = static_cast<double>(count), hours = seconds_ * seeds / 3600;
        console_.out << "estimated: " << counted(runs, "run") << ", "
                     << evaluations_text(evaluations_ * seeds) << '\n'
                     << "  time    " << to_fixed(hours, 2) << " core-hours ("
                     << long_time(seconds_ * seeds / threads_) << " on " << counted(threads_, "thread")
                     << "), if all individuals take as long as the trial lives\n"
                     << "  disk    " << size_text(bytes * seeds) << ", and " << size_text(unfinished)
                     << " more for each unfinished run, from runs of " << measured_generations
                     << " generations of " << measured_population << "\n  memory  "
                     << to_fixed(peak_megabytes() + archive_ / 1e6, 0)
                     << " MB, as this check took, and the archive\n"
                     << "planula run --forecast measures them.\n";
    }

    /// A small run like those of the setting; what it writes depends on little else.
    const Measured &measured(std::size_t index) {
        const Spec &spec = experiment_.settings[index];
        const auto [known, is_new] = measured_.try_emplace({spec.search, spec.actuation});
        if (!is_new) return known->second;
        SettingForRun own = setting_for_run(experiment_, index);
        own.spec.start.reset();
        own.spec.engine = Spec().engine;
        own.spec.parameters.neat.population = std::min(spec.parameters.neat.population, measured_population);
        known->second = measure(own.spec, 1, measured_generations, threads_, [&] { return stop(); });
        return known->second;
    }

    const Arguments &arguments_;
    Console &console_;
    const Experiment experiment_;
    const int threads_;
    const Interrupt interrupt_;
    Findings findings_;
    std::map<Actuation, std::vector<Genome>> specimens_;
    std::map<std::string, Tried> tried_;                             // by conditions_text()
    std::map<std::pair<std::string, Actuation>, Measured> measured_; // by search and actuation
    std::size_t lives_ = 0, viable_ = 0;
    double simulated_seconds_ = 0;                       // of a processor
    double seconds_ = 0, evaluations_ = 0, archive_ = 0; // of one seed of each setting
};

int check(const Arguments &arguments, Console &console) { return Check(arguments, console).run(); }

} // namespace

const Command &check_command() {
    static const Command command{
        "check",
        "FILE.lua",
        "checks that an experiment will run, and estimates what it takes",
        R"(Reads the script, checks every key and value, and calls its functions with an example of every outcome
that the simulation of an individual can have. Then it looks for what the script states and nothing reads, and simulates evolved
specimens in the environment of each setting, with its engine and parameters, and calls its functions with their lives.

Errors, with exit code 65: what cannot be read; a function that fails for a specimen, or returns a value that is not allowed for all of
them. Warnings, with exit code 0, on lines that start with "warning:": nobody is valid; fitness or behaviour is the same for all; no
specimen survives or moves in the environment; a parameter, a number of the environment or a function changes nothing. A line
that starts with ok names the settings; time, disk space and memory of all runs are estimated from the trial lives.)",
        check_options,
        check};
    return command;
}

} // namespace planula
