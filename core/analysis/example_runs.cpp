// SPDX-License-Identifier: MIT
#include "analysis/example_runs.h"

#include <algorithm>
#include <type_traits>

namespace planula {

namespace {

/// Between 0 and 2, rising with the generations, and different for each run of each setting.
double example_value(std::size_t setting, std::size_t run, int generations) {
    const double time = generations / (generations + 10.0);
    return time * (1 + 0.1 * static_cast<double>(run) + 0.03 * static_cast<double>(setting % 10));
}

/// Sets every number of a row; those that may be missing only if `complete`.
template <class Row> Row example_row(double value, bool complete) {
    Row row;
    each_column(row, [&](std::string_view, auto &column) {
        using Column = std::remove_reference_t<decltype(column)>;
        if constexpr (std::is_same_v<Column, Maybe>)
            column = complete ? Maybe(value) : std::nullopt;
        else if constexpr (std::is_same_v<Column, double>)
            column = value;
        else if constexpr (std::is_integral_v<Column>)
            column = static_cast<Column>(1 + 10 * value);
    });
    return row;
}

RunFacts example_facts(double value, int generations, bool complete) {
    RunFacts facts;
    facts.champion = example_row<ChampionRow>(value, true);
    facts.champion.generation = generations - 1;
    facts.champion.late_share = facts.champion.late_actuation = 0.25;
    facts.champion.elongation = 1 + value;
    facts.size_entropy = value;
    facts.with_fitness = 10 * generations;
    facts.valid_share = value / 2;
    if (complete) facts.fitness_spread = facts.direction_resultant = value / 2;
    facts.side_switches = generations / 3;
    return facts;
}

RunHistory example_history(std::size_t setting, std::size_t run, int generations, bool complete) {
    RunHistory history;
    history.seed = static_cast<std::int64_t>(run) + 1;
    for (int g = 1; g <= generations; ++g) {
        const double value = example_value(setting, run, g);
        history.generations.push_back(example_row<GenerationRow>(value, complete));
        history.generations.back().generation = g - 1;
        history.after[g] = example_facts(value, g, complete);
    }
    return history;
}

std::vector<EndpointRow> example_endpoints(const SettingRuns &setting, std::size_t run) {
    std::vector<EndpointRow> rows;
    for (int i = 0; i < 4; ++i)
        rows.push_back({setting.spec->name, setting.runs[run].seed, "", i % setting.generations, 1.0 + i,
                        static_cast<double>(run) - i});
    return rows;
}

std::vector<ArchiveEntry> example_archive(const SettingRuns &setting, std::size_t run) {
    std::vector<ArchiveEntry> entries;
    for (int i = 0; i < 4; ++i)
        entries.push_back(
            {i % setting.generations, i, {1.0 + i, static_cast<double>(run)}, 2.0 + i, 1.0 + i});
    return entries;
}

} // namespace

std::vector<SettingRuns> example_runs(std::span<const Spec> settings, const Parameters &planned) {
    constexpr int most_runs = 3;
    const int runs = std::clamp(planned.design.seeds, 1, most_runs);
    std::vector<SettingRuns> all;
    for (const Spec &spec : settings) {
        SettingRuns &setting = all.emplace_back();
        setting.spec = &spec;
        setting.generations = std::max(spec.parameters.design.generations, planned.design.generations);
        for (int run = 0; run < runs; ++run) {
            setting.runs.push_back({.setting = spec.name,
                                    .seed = run + 1,
                                    .generations = setting.generations,
                                    .population = spec.parameters.neat.population});
            setting.histories.push_back(example_history(all.size(), static_cast<std::size_t>(run),
                                                        setting.generations, run + 1 < most_runs));
        }
    }
    return all;
}

RunData example_data(const Analysis &analysis, std::span<const SettingRuns> examples) {
    return {analysis, examples, example_endpoints, example_archive};
}

} // namespace planula
