// SPDX-License-Identifier: MIT
#include "analysis/witness.h"

#include "analysis/simulate_again.h"
#include "analysis/survey.h"
#include "base/parallel.h"
#include "statistics/rank_correlation.h"
#include "statistics/summary.h"
#include "tables/csv.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace planula {

namespace {

constexpr std::size_t fewest_correlated = 3;

Maybe height(const Life &life) { return life.outcome == Outcome::viable ? Maybe(life.rest.y) : std::nullopt; }

/// The champion's lives; `own`, under the setting as it is, is simulated already.
WitnessedLives lives_of(const Genome &genome, const Spec &spec, const Life &own) {
    Conditions native = spec, bullet = spec;
    native.engine = "native", bullet.engine = "bullet";
    Conditions half = native, eighth = native;
    half.refinement *= 2, eighth.refinement *= 8;
    Conditions nudged = eighth;
    WitnessedLives lives{spec.engine == native.engine ? own : live(genome, native),
                         live(genome, half),
                         live(genome, eighth),
                         spec.engine == bullet.engine ? own : live(genome, bullet),
                         {},
                         held_unrest(genome, native)};
    for (int number = 0; number < spec.parameters.statistics.witness_nudges; ++number) {
        nudged.nudge = {spec.parameters.statistics.witness_nudge, number};
        lives.nudged.push_back(live(genome, nudged));
    }
    return lives;
}

/// How far one life is from another, and whether that is too far.
struct Difference {
    double change;
    bool beyond;
};

Difference difference(const Spec &spec, const Life &native, const Life &other) {
    const double from = native.displacement();
    const double by =
        std::abs(other.displacement() - from) / std::max(from, 2 * spec.parameters.development.cell_radius);
    return {by, by > spec.parameters.statistics.exploit_bound || other.outcome != Outcome::viable};
}

/// The widest difference of several lives.
Difference widest(const Spec &spec, const Life &native, std::span<const Life> others) {
    Difference all{0, false};
    for (const Life &other : others) {
        const Difference one = difference(spec, native, other);
        all = {std::max(all.change, one.change), all.beyond || one.beyond};
    }
    return all;
}

/// The row of a run; none if its champion is not viable.
std::optional<WitnessRow> examine(const Spec &spec, const RecordedRun &run) {
    check_files(run);
    const int generations = spec.parameters.design.generations;
    const ChampionRow champion = champion_after(read_champions(run), generations);
    const RecordedIndividual recorded{run.folder / ChampionRow::file_name,
                                      read_champion_genome(run, generations), champion.fitness,
                                      champion.displacement, champion.cells};
    const Life own = simulate_again(recorded, spec);
    if (own.outcome != Outcome::viable) return std::nullopt;

    return witness_row(spec, champion, run.seed, lives_of(recorded.genome, spec, own));
}

/// One column of the champions' rows.
std::vector<double> column(std::span<const WitnessRow> rows, double WitnessRow::*member) {
    std::vector<double> values;
    for (const WitnessRow &row : rows) values.push_back(row.*member);
    return values;
}

} // namespace

double held_unrest(const Genome &genome, Conditions conditions) {
    conditions.held_from = conditions.parameters.gait.locomotion_steps;
    conditions.parameters.gait.locomotion_steps *= 2;
    const Parameters p = refined(conditions.parameters, conditions.refinement);
    std::vector<Vec2d> before, velocities;
    double at_end = 0;
    Watch watch;
    watch.move = [&](int step, std::span<const Vec2d> nodes, std::span<const double>) {
        if (step == p.gait.locomotion_steps - 1) before.assign(nodes.begin(), nodes.end());
        if (step != p.gait.locomotion_steps) return;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            velocities.push_back((nodes[i] - before[i]) / p.development.time_step);
        at_end = unrest(nodes, velocities);
    };
    const Life life = live(genome, conditions, watch);
    return life.outcome == Outcome::exploded ? p.body.node_speed_limit / p.development.time_step : at_end;
}

WitnessRow witness_row(const Spec &spec, const ChampionRow &champion, std::int64_t seed,
                       const WitnessedLives &lives) {
    const auto &[native, half, eighth, bullet, nudged, held] = lives;
    const Difference by_half = difference(spec, native, half), by_eighth = difference(spec, native, eighth),
                     by_bullet = difference(spec, native, bullet), by_nudge = widest(spec, eighth, nudged);
    WitnessRow row{.setting = spec.name,
                   .seed = seed,
                   .fitness = champion.fitness,
                   .cells = champion.cells,
                   .elongation = champion.elongation,
                   .displacement = native.displacement(),
                   .settle_steps = native.settle_steps,
                   .rest_height = height(native),
                   .half_outcome = name_of(half.outcome),
                   .half_displacement = half.displacement(),
                   .half_change = by_half.change,
                   .eighth_outcome = name_of(eighth.outcome),
                   .eighth_displacement = eighth.displacement(),
                   .eighth_change = by_eighth.change,
                   .bullet_outcome = name_of(bullet.outcome),
                   .bullet_displacement = bullet.displacement(),
                   .bullet_change = by_bullet.change,
                   .bullet_settle_steps = bullet.settle_steps,
                   .bullet_rest_height = height(bullet),
                   .nudged_change = by_nudge.change,
                   .held_unrest = held,
                   .flag = by_half.beyond                                   ? "integration exploit"
                           : held > spec.parameters.statistics.unrest_bound ? "perpetual motion"
                                                                            : "",
                   .cause = ""};
    const bool by_step = by_half.beyond || by_eighth.beyond;
    if (by_step || by_bullet.beyond) row.cause = by_nudge.beyond ? "chaos" : by_step ? "time step" : "engine";
    return row;
}

EngineRow engine_row(const Spec &spec, std::span<const WitnessRow> champions) {
    EngineRow row{.setting = spec.name, .champions = static_cast<int>(champions.size())};
    if (champions.empty()) return row;
    if (champions.size() >= fewest_correlated)
        row.rank_correlation = rank_correlation(column(champions, &WitnessRow::displacement),
                                                column(champions, &WitnessRow::bullet_displacement));
    const std::vector<double> half = column(champions, &WitnessRow::half_change);
    const std::vector<double> bullet = column(champions, &WitnessRow::bullet_change);
    row.half_change_median = median(half);
    row.half_change_largest = *std::max_element(half.begin(), half.end());
    row.bullet_change_median = median(bullet);
    row.bullet_change_largest = *std::max_element(bullet.begin(), bullet.end());
    const std::vector<double> held = column(champions, &WitnessRow::held_unrest);
    row.held_unrest_largest = *std::max_element(held.begin(), held.end());
    for (const WitnessRow &r : champions) {
        row.flagged += !r.flag.empty();
        row.cause_chaos += r.cause == "chaos";
        row.cause_time_step += r.cause == "time step";
        row.cause_engine += r.cause == "engine";
        if (r.rest_height && r.bullet_rest_height)
            row.height_change_largest = std::max(row.height_change_largest.value_or(0),
                                                 std::abs(*r.bullet_rest_height - *r.rest_height));
    }
    return row;
}

void witness(std::span<const Spec> settings, const RunChoice &runs, const std::filesystem::path &out,
             int threads) {
    struct Task {
        const Spec *spec;
        const RecordedRun *run;
    };
    const FolderLock held = hold_for_tables(out);
    const std::vector<SettingRuns> found = survey(settings, runs);
    std::vector<Task> tasks;
    for (const SettingRuns &setting : found)
        for (const RecordedRun &run : setting.runs) tasks.push_back({setting.spec, &run});

    std::vector<std::optional<WitnessRow>> rows(tasks.size());
    parallel_for(static_cast<int>(tasks.size()), threads,
                 [&](int i) { rows[i] = examine(*tasks[i].spec, *tasks[i].run); });

    // The rows are in the order of settings and seeds, whichever thread made them.
    TableWriter<WitnessRow> champions(out);
    TableWriter<EngineRow> engines(out);
    auto next = rows.begin();
    for (const SettingRuns &setting : found) {
        std::vector<WitnessRow> of_setting;
        for (std::size_t run = 0; run < setting.runs.size(); ++run, ++next)
            if (*next) of_setting.push_back(**next), champions.write(**next);
        if (!setting.runs.empty()) engines.write(engine_row(*setting.spec, of_setting));
    }
    champions.commit();
    engines.commit();
}

} // namespace planula
