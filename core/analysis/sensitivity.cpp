// SPDX-License-Identifier: MIT
#include "analysis/sensitivity.h"

#include "analysis/chance.h"
#include "analysis/survey.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/random.h"
#include "base/text.h"
#include "evaluation/live.h"
#include "experiment/world_numbers.h"
#include "record/kept_state.h"
#include "statistics/rank_correlation.h"
#include "statistics/summary.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace planula {

namespace {

constexpr double lower_quartile = 0.25, upper_quartile = 0.75;
constexpr std::string_view origin_ours = "ours";
// Recorded with a life, but no part of it.
constexpr std::string_view only_recorded = "path_interval";

/// A genome that may enter the sample.
struct Drawn {
    double lot;
    std::int64_t seed;
    int slot;
    Genome genome;
};

/// The genomes of the last generation that the setting asks for.
std::vector<Genome> last_population(const RecordedRun &run, const Spec &spec) {
    const int last = spec.parameters.design.generations - 1;
    if (last + 1 != run.generations && !is_kept_generation(last))
        throw InputError(run.folder.string() + ": the genomes of generation " + to_text(last) +
                         " are not kept in a run of " + to_text(run.generations) + " generations");
    return read_run_state(run, spec, last).population.genomes;
}

/// The `count` lowest lots of all last generations, in the order of seeds and slots.
std::vector<Genome> draw(const SettingRuns &setting, int count) {
    std::vector<Drawn> drawn;
    for (const RecordedRun &run : setting.runs) {
        check_files(run);
        int slot = 0;
        for (Genome &genome : last_population(run, *setting.spec)) {
            Stream stream(bootstrap_seed(setting.spec->name + " sensitivity"),
                          static_cast<std::uint32_t>(run.seed), static_cast<std::uint32_t>(slot),
                          Purpose::sampling);
            drawn.push_back({stream.uniform(), run.seed, slot++, std::move(genome)});
        }
        // Only the best so far are kept, so that memory does not grow with the number of runs.
        std::stable_sort(drawn.begin(), drawn.end(),
                         [](const Drawn &a, const Drawn &b) { return a.lot < b.lot; });
        if (drawn.size() > static_cast<std::size_t>(count)) drawn.resize(static_cast<std::size_t>(count));
    }
    std::stable_sort(drawn.begin(), drawn.end(), [](const Drawn &a, const Drawn &b) {
        return a.seed != b.seed ? a.seed < b.seed : a.slot < b.slot;
    });
    std::vector<Genome> genomes;
    for (Drawn &each : drawn) genomes.push_back(std::move(each.genome));
    return genomes;
}

std::vector<Life> live_all(std::span<const Genome> genomes, const Conditions &conditions, int threads) {
    std::vector<Life> lives(genomes.size());
    parallel_for(static_cast<int>(lives.size()), threads,
                 [&](int i) { lives[i] = live(genomes[i], conditions); });
    return lives;
}

int viable(std::span<const Life> lives) {
    return static_cast<int>(std::count_if(lives.begin(), lives.end(),
                                          [](const Life &life) { return life.outcome == Outcome::viable; }));
}

std::vector<double> displacements(std::span<const Life> lives) {
    std::vector<double> all;
    for (const Life &life : lives) all.push_back(life.displacement());
    return all;
}

} // namespace

std::vector<Sample> draw_samples(std::span<const Spec> settings, const RunChoice &runs, int count,
                                 int threads) {
    std::vector<Sample> samples;
    for (const SettingRuns &setting : survey(settings, runs)) {
        if (setting.runs.empty()) continue;
        Sample &sample = samples.emplace_back();
        sample.spec = setting.spec;
        sample.population = setting.runs.front().population;
        sample.generations = setting.generations;
        sample.genomes = draw(setting, count);
        sample.lives = live_all(sample.genomes, *sample.spec, threads);
    }
    return samples;
}

bool concerns(const ParameterRow &parameter, const Spec &spec) {
    if (parameter.name == only_recorded || parameter.is_choice()) return false;
    if (makes_world(parameter.name, spec)) return true;
    if (is_of_worlds(parameter.name) && !stated_instead_of(parameter.name, spec)) return false;
    const auto any_world = [&](const auto &holds) {
        return holds(spec.environment) ||
               std::any_of(spec.phases.begin(), spec.phases.end(),
                           [&](const Phase &phase) { return holds(phase.environment); });
    };
    if (parameter.section == "Water") return any_world([](const Environment &e) { return e.has_fluid(); });
    if (parameter.section == "Land" || parameter.section == "Settling")
        return any_world([](const Environment &e) { return e.has_ground; });
    constexpr std::array<std::string_view, 4> always{"Development", "Control network", "Body", "Gait"};
    return std::find(always.begin(), always.end(), parameter.section) != always.end();
}

double used(const ParameterRow &parameter, const Spec &spec) {
    if (const WorldNumber *number = stated_instead_of(parameter.name, spec)) return value_of(*number, spec);
    return planula::parameter(spec.parameters, parameter.name);
}

std::vector<std::string_view> assumed_parameters() {
    Spec both;
    both.environment.has_ground = true;
    both.environment.drag_normal = 1;
    std::vector<std::string_view> names;
    for (const ParameterRow &row : parameter_rows())
        if (row.origin == origin_ours && concerns(row, both)) names.push_back(row.name);
    return names;
}

double varied(const ParameterRow &parameter, double standard, double factor) {
    const double value = std::clamp(standard * factor, std::min(parameter.lowest, standard),
                                    std::max(parameter.highest, standard));
    return parameter.whole ? std::round(value) : value;
}

SensitivityRow vary(const Sample &sample, const Spec &changed, const ParameterRow &parameter, int threads) {
    const std::vector<Life> after = live_all(sample.genomes, changed, threads);
    SensitivityRow row{.setting = sample.spec->name,
                       .parameter = std::string(parameter.name),
                       .standard = used(parameter, *sample.spec),
                       .value = used(parameter, changed),
                       .population = sample.population,
                       .generations = sample.generations,
                       .sampled = static_cast<int>(after.size()),
                       .viable_before = viable(sample.lives),
                       .viable_after = viable(after)};
    if (after.empty()) return row;

    std::vector<double> ratios;
    for (std::size_t i = 0; i < after.size(); ++i)
        if (after[i].outcome == Outcome::viable && sample.lives[i].displacement() > 0)
            ratios.push_back(after[i].displacement() / sample.lives[i].displacement());
    if (!ratios.empty()) {
        row.ratio_low = quantile(ratios, lower_quartile);
        row.ratio_median = median(ratios);
        row.ratio_high = quantile(ratios, upper_quartile);
    }

    const std::vector<double> from = displacements(sample.lives), to = displacements(after);
    const double farthest = *std::max_element(from.begin(), from.end());
    if (farthest > 0) row.best_ratio = *std::max_element(to.begin(), to.end()) / farthest;
    row.rank_correlation = rank_correlation(from, to);
    return row;
}

} // namespace planula
