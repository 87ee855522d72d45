// SPDX-License-Identifier: MIT
#include "analysis/tables.h"

#include "analysis/chance.h"
#include "experiment/sample.h"
#include "experiment/world_numbers.h"
#include "statistics/bootstrap.h"
#include "statistics/summary.h"
#include "tables/archive_table.h"
#include "tables/genome_table.h"

#include <algorithm>
#include <array>
#include <functional>
#include <utility>

namespace planula {

namespace {

int count_of(const SettingRuns &setting) { return static_cast<int>(setting.runs.size()); }

/// Calls make(history, facts) for each run.
template <class Make> auto from_runs(const SettingRuns &setting, Make &&make) {
    std::vector<decltype(make(setting.histories[0], setting.outcome_of(0)))> values;
    for (std::size_t run = 0; run < setting.histories.size(); ++run)
        values.push_back(make(setting.histories[run], setting.outcome_of(run)));
    return values;
}

/// The interval of a mean over runs; none if there are too few.
struct MaybeInterval {
    Maybe low, high;
};
MaybeInterval interval_of_mean(std::span<const double> of_runs, const Analysis &analysis,
                               const std::string &what) {
    if (static_cast<int>(of_runs.size()) < analysis.interval_runs) return {};
    const Interval interval =
        bootstrap_mean(of_runs, {analysis.confidence, analysis.resamples, bootstrap_seed(what), 0});
    return {interval.low, interval.high};
}

/// The mean over runs of one value of each generation, with its bootstrap interval.
template <class Row>
std::vector<Row> mean_over_runs(const SettingRuns &setting, const Analysis &analysis, const std::string &what,
                                double GenerationRow::*value) {
    // One stream for all generations: each resample draws whole runs, so that the band is as smooth as they
    // are.
    std::vector<Row> rows;
    for (int generation = 0; generation < setting.generations; ++generation) {
        const std::vector<double> of_runs =
            from_runs(setting, [&](const RunHistory &history, const RunFacts &) {
                return history.generations[static_cast<std::size_t>(generation)].*value;
            });
        const MaybeInterval interval = interval_of_mean(of_runs, analysis, what + " " + setting.spec->name);
        rows.push_back(
            {setting.spec->name, generation, count_of(setting), mean(of_runs), interval.low, interval.high});
    }
    return rows;
}

OutcomeRow outcome_row(const SettingRuns &setting, int generation) {
    OutcomeRow row{.setting = setting.spec->name};
    const double individuals =
        static_cast<double>(setting.histories.size()) * setting.spec->parameters.neat.population;
    row.generation = generation;
    const auto share = [&](int GenerationRow::*outcome) {
        std::int64_t count = 0;
        for (const RunHistory &history : setting.histories)
            count += history.generations[static_cast<std::size_t>(generation)].*outcome;
        return static_cast<double>(count) / individuals;
    };
    row.viable = share(&GenerationRow::viable);
    row.died_out = share(&GenerationRow::died_out);
    row.too_small = share(&GenerationRow::too_small);
    row.overgrown = share(&GenerationRow::overgrown);
    row.never_settled = share(&GenerationRow::never_settled);
    row.exploded = share(&GenerationRow::exploded);
    row.overborn = share(&GenerationRow::overborn);
    return row;
}

} // namespace

SettingRow setting_row(const SettingRuns &setting) {
    const Spec &spec = *setting.spec;
    return {.setting = spec.name,
            .title = spec.title,
            .actuation = name_of(spec.actuation),
            .world = spec.environment.has_ground ? "terrestrial" : "aquatic",
            .search = spec.search,
            .runs = count_of(setting),
            .generations = setting.generations,
            .population = spec.parameters.neat.population};
}

std::vector<WorldRow> world_rows(const SettingRuns &setting) {
    const Spec &spec = *setting.spec;
    std::vector<WorldRow> rows;
    const auto add = [&](const Conditions &conditions, const auto &called) {
        for (const WorldNumber &number : world_numbers())
            if (is_stated(number, conditions))
                rows.push_back({spec.name, called(number.name), value_of(number, conditions),
                                std::string(number.unit), std::string(source_of(called(number.name), spec))});
        Maybe points;
        if (conditions.environment.has_ground)
            points = static_cast<double>(conditions.environment.ground.size());
        rows.push_back({spec.name, called("ground points"), points, "points", ""});
        const auto add_count = [&](const char *name, std::size_t count, const char *unit) {
            if (count > 0) rows.push_back({spec.name, called(name), static_cast<double>(count), unit, ""});
        };
        add_count("obstacles", conditions.environment.obstacles.size(), "obstacles");
        add_count("ceiling points", conditions.environment.ceiling.size(), "points");
        add_count("friction patches", conditions.environment.friction_patches.size(), "patches");
        add_count("object cells", conditions.environment.object.positions.size(), "cells");
    };
    add(spec, [](std::string_view name) { return std::string(name); });
    for (std::size_t i = 0; i < spec.phases.size(); ++i)
        add(conditions_of(spec.phases[i]), [&](std::string_view name) { return name_in_phase(i, name); });
    return rows;
}

std::vector<RunRow> run_rows(const SettingRuns &setting) {
    return from_runs(setting, [&](const RunHistory &history, const RunFacts &facts) -> RunRow {
        const ChampionRow &champion = facts.champion;
        return {.setting = setting.spec->name,
                .seed = history.seed,
                .generations = setting.generations,
                .best_fitness = champion.fitness,
                .best_displacement = champion.displacement,
                .best_generation = champion.generation,
                .best_cells = champion.cells,
                .late_share = champion.late_share,
                .late_actuation = champion.late_actuation,
                .elongation = champion.elongation,
                .size_entropy = facts.size_entropy,
                .with_fitness = facts.with_fitness,
                .valid_share_last = facts.valid_share,
                .fitness_spread_last = facts.fitness_spread,
                .shape_diversity_first = history.generations.front().shape_diversity,
                .shape_diversity_last = history.generations.back().shape_diversity,
                .direction_resultant = facts.direction_resultant,
                .side_switches = facts.side_switches};
    });
}

std::vector<CurveRow> curve_rows(const SettingRuns &setting, const Analysis &analysis) {
    return mean_over_runs<CurveRow>(setting, analysis, "curve", &GenerationRow::best_fitness);
}

std::vector<ShapeDiversityRow> shape_diversity_rows(const SettingRuns &setting, const Analysis &analysis) {
    return mean_over_runs<ShapeDiversityRow>(setting, analysis, "shape diversity",
                                             &GenerationRow::shape_diversity);
}

std::vector<HeredityRow> heredity_rows(const SettingRuns &setting) {
    constexpr std::array measures{std::pair{&HeredityRow::heredity_fitness, &GenerationRow::heredity_fitness},
                                  std::pair{&HeredityRow::heredity_cells, &GenerationRow::heredity_cells},
                                  std::pair{&HeredityRow::kept_fitness, &GenerationRow::kept_fitness},
                                  std::pair{&HeredityRow::near_mother, &GenerationRow::near_mother},
                                  std::pair{&HeredityRow::cells_change, &GenerationRow::cells_change},
                                  std::pair{&HeredityRow::cyclic, &GenerationRow::cyclic}};
    std::vector<HeredityRow> rows;
    for (int generation = 0; generation < setting.generations; ++generation) {
        HeredityRow row{.setting = setting.spec->name, .generation = generation, .runs = count_of(setting)};
        const auto median_of = [&](const auto &measure) -> Maybe {
            std::vector<double> known;
            for (const RunHistory &history : setting.histories)
                if (const Maybe value = measure(history.generations[static_cast<std::size_t>(generation)]))
                    known.push_back(*value);
            return known.empty() ? std::nullopt : Maybe(median(known));
        };
        for (const auto &measure : measures)
            row.*measure.first =
                median_of([&](const GenerationRow &of_run) { return of_run.*measure.second; });
        row.near_best = median_of([](const GenerationRow &of_run) { return Maybe(of_run.near_best); });
        rows.push_back(row);
    }
    return rows;
}

EntropyRow entropy_row(const SettingRuns &setting, const Analysis &analysis) {
    const std::vector<double> entropies =
        from_runs(setting, [](const RunHistory &, const RunFacts &facts) { return facts.size_entropy; });
    const MaybeInterval interval = interval_of_mean(entropies, analysis, "entropy " + setting.spec->name);
    return {setting.spec->name, count_of(setting), mean(entropies),
            interval.low,       interval.high,     median(entropies)};
}

std::vector<OutcomeRow> outcome_rows(const SettingRuns &setting) {
    std::vector<OutcomeRow> rows{outcome_row(setting, 0)};
    if (setting.generations > 1) rows.push_back(outcome_row(setting, setting.generations - 1));
    return rows;
}

std::vector<FitnessShareRow> fitness_share_rows(const SettingRuns &setting) {
    std::vector<FitnessShareRow> rows;
    const std::size_t classes = setting.histories.front().fitness_shares.back().size();
    for (std::size_t i = 0; i < classes; ++i) {
        const std::vector<double> shares =
            from_runs(setting, [&](const RunHistory &history, const RunFacts &) {
                return history.fitness_shares.back()[i];
            });
        const auto edge = [&](std::size_t at) {
            return static_cast<double>(at) / static_cast<double>(classes);
        };
        rows.push_back({setting.spec->name, count_of(setting), edge(i), edge(i + 1), mean(shares)});
    }
    return rows;
}

std::vector<BestGenomeRow> best_genome_rows(const SettingRuns &setting) {
    const std::vector<std::size_t> order = ranking(setting);
    std::vector<BestGenomeRow> rows;
    for (std::size_t i = 0; i < std::min(order.size(), shown_runs); ++i) {
        const RecordedRun &run = setting.runs[order[i]];
        const ChampionRow &champion = setting.outcome_of(order[i]).champion;
        for (const GenomeRow &gene : genome_rows(read_champion_genome(run, setting.generations)))
            rows.push_back({.setting = setting.spec->name,
                            .rank = static_cast<int>(i) + 1,
                            .seed = run.seed,
                            .fitness = champion.fitness,
                            .displacement = champion.displacement,
                            .cells = champion.cells,
                            .kind = gene.kind,
                            .id = gene.id,
                            .from = gene.from,
                            .to = gene.to,
                            .value = gene.value,
                            .recurrent = gene.recurrent});
    }
    return rows;
}

std::vector<Representative> representatives(const SettingRuns &setting) {
    const std::vector<std::size_t> order = ranking(setting);
    return {{"best", order.front()}, {"median", order[rank_below_median(order.size())]}};
}

std::vector<EndpointPathRow> endpoint_path_rows(const SettingRuns &setting, const Representative &chosen) {
    const RunHistory &history = setting.histories[chosen.run];
    std::vector<EndpointPathRow> rows;
    for (int generation = 0; generation < setting.generations; ++generation) {
        const GenerationRow &row = history.generations[static_cast<std::size_t>(generation)];
        rows.push_back({setting.spec->name, history.seed, chosen.role, generation, row.best_x, row.best_y,
                        row.best_fitness});
    }
    return rows;
}

std::vector<EndpointRow> endpoint_rows(const SettingRuns &setting, const Representative &chosen,
                                       double share) {
    const RecordedRun &run = setting.runs[chosen.run];
    std::vector<EndpointRow> rows;
    each_individual(run, setting.generations, [&](const IndividualRow &row) {
        const bool is_drawn = lot(static_cast<std::uint64_t>(run.seed), row.generation, row.slot) < share;
        if (!is_drawn || row.outcome != name_of(Outcome::viable)) return;
        rows.push_back({setting.spec->name, run.seed, chosen.role, row.generation, row.finish_x - row.rest_x,
                        row.finish_y - row.rest_y});
    });
    return rows;
}

double sampled_share(const SettingRuns &setting, const Analysis &analysis) {
    return sample_share(analysis.sample_share, analysis.sample_least,
                        setting.spec->parameters.neat.population, setting.generations);
}

std::vector<ArchivePointRow> archive_point_rows(const SettingRuns &setting) {
    const RecordedRun &run = setting.runs[ranking(setting).front()];
    std::vector<ArchivePointRow> rows;
    if (!run.manifest.has(ArchiveRow::file_name)) return rows;
    for (const ArchiveEntry &entry : read_archive(run.folder)) {
        if (entry.generation >= setting.generations || entry.behaviour.empty()) continue;
        const Maybe second = entry.behaviour.size() > 1 ? Maybe(entry.behaviour[1]) : std::nullopt;
        rows.push_back({setting.spec->name, run.seed, entry.generation, entry.behaviour[0], second});
    }
    return rows;
}

} // namespace planula
