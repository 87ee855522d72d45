// SPDX-License-Identifier: MIT
#include "statement/trial_lives.h"

#include "base/error.h"
#include "base/text.h"
#include "evaluation/live.h"
#include "experiment/deciding.h"
#include "experiment/identity.h"
#include "experiment/world_numbers.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>

namespace planula {

namespace {

constexpr double least_movement = 0.01; // cells: whoever ends nearer has not moved

/// "all 8 trial lives", "3 of 8 trial lives".
std::string share_of(std::size_t count, std::size_t all) {
    const std::string whole = to_text(static_cast<std::int64_t>(all));
    return (count == all ? "all " : to_text(static_cast<std::int64_t>(count)) + " of ") + whole +
           " trial lives";
}

std::string text_of(std::span<const double> numbers) {
    std::vector<std::string> texts;
    for (const double number : numbers) texts.push_back(to_text(number));
    return "{" + list_of(texts) + "}";
}

std::size_t viable_among(std::span<const Life> lives) {
    return static_cast<std::size_t>(std::count_if(
        lives.begin(), lives.end(), [](const Life &life) { return life.outcome == Outcome::viable; }));
}

/// What decides neither growth nor movement of one individual.
bool is_of_evolution(const std::string &key) {
    constexpr std::string_view parameter_key = "parameter ";
    if (!key.starts_with(parameter_key)) return key == "seed" || key == "search" || key == "start";
    constexpr std::array<std::string_view, 3> sections{"NEAT", "Novelty search", "MAP-Elites"};
    const std::string_view section = parameter_row(key.substr(parameter_key.size())).section;
    return std::find(sections.begin(), sections.end(), section) != sections.end();
}

std::vector<Life> simulate(std::span<const Genome> genomes, const Workers &workers, const StopRequest &stop,
                           const std::function<Life(const Genome &)> &life_of) {
    std::vector<Life> lives(genomes.size());
    workers.each(static_cast<int>(lives.size()), [&](int i) {
        if (stop()) throw Stopped("stopped in the trial lives");
        lives[static_cast<std::size_t>(i)] = life_of(genomes[static_cast<std::size_t>(i)]);
    });
    return lives;
}

class SettingTrial {
  public:
    SettingTrial(const Experiment &experiment, std::size_t index, Findings &findings)
        : experiment_(experiment), index_(index), spec_(experiment.settings[index]), findings_(findings) {}

    void judge(const TrialLives &lives) {
        judge_world(lives.complete);
        judge_lives(lives.complete, Stage::life);
        if (spec_.start) judge_lives(lives.grown, Stage::growth);
    }

    void warn(const std::string &place, const std::string &text) { report(false, place, text); }
    std::string place_of(const std::string &key) const {
        const Places &places = experiment_.places[index_];
        const auto stated = places.find(key);
        return stated == places.end() ? places.at("") : stated->second;
    }

  private:
    void report(bool is_error, const std::string &place, const std::string &text) {
        findings_.add({is_error, place, text, {spec_.name}});
    }

    std::string place_of_function(const std::string &name) const {
        for (const FunctionMeaning &function : spec_.judgement)
            if (function.name == name) return function.place;
        return place_of(name);
    }

    // The world: what becomes of bodies that evolved in the paper's.
    void judge_world(std::span<const Life> lives) {
        const std::size_t viable = viable_among(lives);
        if (viable == 0) return warn_of_outcomes(lives);
        double farthest = 0;
        std::size_t below = 0;
        for (const Life &life : lives) {
            if (life.outcome != Outcome::viable) continue;
            farthest = std::max(farthest, life.displacement());
            if (spec_.environment.has_ground &&
                life.finish.y < ground_height(spec_.environment, life.finish.x))
                ++below;
        }
        const std::string of_all = share_of(viable, viable);
        if (farthest < least_movement)
            warn(place_of("environment"), "nobody moves: " + of_all + " end within " +
                                              to_text(least_movement) + " cells of where they began");
        if (below == viable) warn(place_of("environment"), of_all + " end below the ground");
    }

    void warn_of_outcomes(std::span<const Life> lives) {
        std::map<Outcome, std::size_t> counts;
        for (const Life &life : lives) ++counts[life.outcome];
        std::vector<std::string> texts;
        for (const auto &[outcome, count] : counts)
            texts.push_back(to_text(static_cast<std::int64_t>(count)) + " " + name_of(outcome));
        const bool grew = counts.contains(Outcome::exploded) || counts.contains(Outcome::never_settled);
        const std::string why = !grew ? "no specimen grows a body with these parameters"
                                : counts.contains(Outcome::exploded)
                                    ? "this world may be too violent for its time step, or its bodies"
                                    : "no body comes to rest before it would move";
        warn(place_of(grew ? "environment" : "parameters"),
             "none of " + to_text(static_cast<std::int64_t>(lives.size())) + " trial lives ends viable (" +
                 list_of(texts) + "): " + why);
    }

    void judge_lives(std::span<const Life> lives, Stage stage) {
        problems_.clear();
        valid_.clear();
        stage_ = stage;
        try {
            JudgingFunctions functions(experiment_.sources, static_cast<int>(index_), spec_.parameters,
                                       stage);
            for (const Life &life : lives) take(functions.try_on(life));
            functions.check_unchanged();
        } catch (const InputError &error) {
            return report_problem(true, error.what(), "");
        }
        const std::size_t viable = viable_among(lives);
        report_problems(lives.size());
        if (valid_.empty() && problems_.empty() && viable > 0 && stage == Stage::life)
            warn(place_of_function("penalty"), "penalty is 0 for " + share_of(viable, viable) +
                                                   " that end viable: nobody would be valid, and the search "
                                                   "would have nobody to select");
        if (valid_.size() > 1) report_constants();
    }

    void take(const JudgingFunctions::Tried &tried) {
        if (!tried.problem.empty()) {
            auto &[count, wrong_kind] = problems_[tried.problem];
            ++count, wrong_kind = tried.wrong_kind;
        } else if (tried.evaluation.valid())
            valid_.push_back(tried.evaluation);
    }

    // Whoever the functions fail for is not valid: with nobody valid, or with a mistake in the code, no run can work.
    void report_problems(std::size_t all) {
        for (const auto &[problem, seen] : problems_) {
            const auto &[count, wrong_kind] = seen;
            const bool is_error = wrong_kind || valid_.empty();
            report_problem(is_error, problem,
                           " for " + share_of(count, all) + " of evolved specimens" +
                               (wrong_kind ? "" : "; such individuals count as not valid"));
        }
    }

    // A problem begins with its place.
    void report_problem(bool is_error, const std::string &problem, const std::string &more) {
        const std::size_t end = problem.find(": ");
        if (end == problem.npos) return report(is_error, place_of(""), problem + more);
        report(is_error, problem.substr(0, end), problem.substr(end + 2) + more);
    }

    void report_constants() {
        const std::string all = share_of(valid_.size(), valid_.size());
        const double fitness = valid_.front().fitness;
        if (stage_ == Stage::life && std::all_of(valid_.begin(), valid_.end(),
                                                 [&](const Evaluation &e) { return e.fitness == fitness; }))
            warn(place_of_function("fitness"),
                 "fitness is " + to_text(fitness) + " for " + all + ": it tells nobody apart");
        if (stage_ == Stage::growth || reads_behaviour(spec_)) report_constant_behaviour(all);
        report_constant_objectives(all);
    }

    void report_constant_objectives(const std::string &all) {
        std::size_t i = 0;
        for (const Objective &objective : spec_.aims.objectives) {
            if (stage_ == Stage::growth || objective.value != Objective::Value::stated) continue;
            const double first = valid_.front().objectives[i];
            if (std::all_of(valid_.begin(), valid_.end(),
                            [&](const Evaluation &e) { return e.objectives[i] == first; }))
                warn(place_of_function("objective " + objective.name), "objective " + objective.name +
                                                                           " is " + to_text(first) + " for " +
                                                                           all + ": it tells nobody apart");
            ++i;
        }
    }

    void report_constant_behaviour(const std::string &all) {
        const std::string name = stage_ == Stage::growth ? "start.behaviour" : "behaviour";
        const std::vector<double> &first = valid_.front().behaviour;
        std::vector<std::size_t> constant;
        for (std::size_t i = 0; i < first.size(); ++i)
            if (std::all_of(valid_.begin(), valid_.end(),
                            [&](const Evaluation &e) { return e.behaviour[i] == first[i]; }))
                constant.push_back(i);
        if (constant.size() == first.size())
            return warn(place_of_function(name),
                        name + " is " + text_of(first) + " for " + all + ": it tells nobody apart");
        for (const std::size_t i : constant)
            warn(place_of_function(name), "number " + to_text(static_cast<std::int64_t>(i + 1)) + " of " +
                                              name + " is " + to_text(first[i]) + " for " + all);
    }

    const Experiment &experiment_;
    const std::size_t index_;
    const Spec &spec_;
    Findings &findings_;
    Stage stage_ = Stage::life;
    std::map<std::string, std::pair<std::size_t, bool>> problems_; // how often, and whether of a wrong kind
    std::vector<Evaluation> valid_;
};

} // namespace

std::string conditions_text(const Spec &spec) {
    std::string text;
    for (const IdentityItem &item : identity_of(spec, 0).items)
        if (!is_of_evolution(item.key)) text += item.key + " = " + item.value + '\n';
    return text;
}

std::vector<Life> complete_lives(const Spec &spec, std::span<const Genome> genomes, const Workers &workers,
                                 const StopRequest &stop) {
    return simulate(genomes, workers, stop, [&](const Genome &genome) { return live(genome, spec); });
}

std::vector<Life> grown_lives(const Spec &spec, std::span<const Genome> genomes, const Workers &workers,
                              const StopRequest &stop) {
    return simulate(genomes, workers, stop, [&](const Genome &genome) { return develop(genome, spec); });
}

void judge_trials(const Experiment &experiment, std::size_t index, const TrialLives &lives,
                  Findings &findings) {
    SettingTrial(experiment, index, findings).judge(lives);
}

void find_idle_numbers(const Experiment &experiment, std::size_t index, std::span<const Genome> genomes,
                       const TrialLives &lives, const StopRequest &stop, Findings &findings) {
    const Spec &spec = experiment.settings[index];
    const Places &stated = experiment.world_places[index];
    if (viable_among(lives.complete) == 0) return;
    for (const WorldNumber &number : world_numbers()) {
        const auto place = stated.find(number.name);
        const double absent = number.absent.value_or(0);
        if (place == stated.end() || value_of(number, spec) == absent) continue;
        Spec without = spec;
        number.in(without) = absent;
        bool is_idle = true;
        for (std::size_t i = 0; i < genomes.size() && is_idle; ++i) {
            if (stop()) throw Stopped("stopped in the trial lives");
            is_idle = live(genomes[i], without) == lives.complete[i];
        }
        if (is_idle)
            findings.add({false,
                          place->second,
                          std::string(number.name) + " = " + to_text(value_of(number, spec)) +
                              " changes nothing: " + share_of(genomes.size(), genomes.size()) +
                              " are the same with " + to_text(absent),
                          {spec.name}});
    }
}

} // namespace planula
