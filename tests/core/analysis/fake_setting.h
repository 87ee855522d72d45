// SPDX-License-Identifier: MIT
// Settings with histories made by hand, for tests of what is done with them.
#pragma once

#include "analysis/statistic.h"
#include "core/record/fake_run.h"

#include <memory>
#include <vector>

namespace planula {

inline Analysis fake_analysis() {
    Analysis analysis;
    analysis.experiment = "fake";
    analysis.sample_share = 0.5;
    analysis.confidence = 0.95;
    analysis.resamples = 500;
    analysis.interval_runs = 3;
    analysis.significance = 0.05;
    analysis.design.design.seeds = 6;
    analysis.design.design.generations = 10;
    analysis.design.neat.population = 10;
    return analysis;
}

/// All runs below a folder; messages about them are dropped.
inline RunChoice runs_in(const std::filesystem::path &folder) { return {.folder = folder}; }

/// A function of claims and tables, in C++: what it says of the runs after so many generations.
using FakeJudge = std::function<Finding(const ClaimCase &, Asked &)>;

/// A claim about setting "ns" against "neat". The judge compares the best fitness of their first runs.
inline Finding compare_first(const ClaimCase &of, Asked &) {
    const auto best = [&](std::size_t setting) {
        const RunHistory &first = of.data.settings[setting].histories.front();
        return first.generations[static_cast<std::size_t>(of.generations) - 1].best_fitness;
    };
    const double effect = best(0) - best(1);
    return {.effect_name = "difference",
            .effect = effect,
            .p = 0.1,
            .method = "exact",
            .verdict = effect > 0 ? "reproduced" : "contradicted",
            .note = "of the first"};
}

inline Claim fake_claim(const FakeJudge &judge = compare_first) {
    return {.id = "S",
            .statement = "ns differs, in a way",
            .section = "§3",
            .paper = "p = 0.01",
            .test = "first",
            .a = "ns",
            .b = "neat",
            .judge = judge};
}

/// Runs whose best fitness is the same in every generation: one run per value. Seeds count from 1.
inline SettingRuns fake_setting(const Spec &spec, const std::vector<double> &values) {
    SettingRuns setting;
    setting.spec = &spec;
    setting.generations = values.empty() ? 0 : spec.parameters.design.generations;
    for (std::size_t i = 0; i < values.size(); ++i) {
        RecordedRun run;
        run.seed = static_cast<std::int64_t>(i) + 1;
        run.generations = spec.parameters.design.generations;
        run.population = spec.parameters.neat.population;
        run.setting = spec.name;
        setting.runs.push_back(run);
        RunHistory history;
        history.seed = run.seed;
        for (int generation = 0; generation < run.generations; ++generation)
            history.generations.push_back({.generation = generation,
                                           .best_fitness = values[i],
                                           .shape_diversity = values[i],
                                           .heredity_fitness = values[i],
                                           .near_best = values[i]});
        for (int after = 1; after <= run.generations; ++after) {
            RunFacts &facts = history.after[after];
            facts.champion.fitness = facts.size_entropy = values[i];
            facts.fitness_spread = facts.direction_resultant = values[i];
            facts.side_switches = static_cast<int>(values[i]);
            facts.champion.late_share = facts.champion.late_actuation = 0.25;
            facts.champion.elongation = 2;
        }
        setting.histories.push_back(history);
    }
    return setting;
}

} // namespace planula
