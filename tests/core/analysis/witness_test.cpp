// SPDX-License-Identifier: MIT
#include "analysis/witness.h"

#include "base/error.h"
#include "core/record/fake_run.h"
#include "evaluation/live.h"
#include "experiment/run.h"
#include "support/print.h"
#include "support/specimens.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <span>

using namespace planula;
namespace tt = boost::test_tools;

namespace {

const ChampionRow champion{.fitness = 21, .cells = 12, .displacement = 20, .elongation = 3};

/// A life that moved so far to the right; its centre of mass at rest is 0.5 high.
Life moved(double distance, Outcome outcome = Outcome::viable) {
    return life_of(FakeLife{.moved = {distance, 0}, .outcome = outcome}, Parameters{});
}

/// At an eighth of the step it lives as at half of it, nudged or not, unless given.
WitnessRow row_of(const Life &native, const Life &half, const Life &bullet, std::vector<Life> nudged = {}) {
    return witness_row(fake_spec("water", 1, 1), champion, 7,
                       {native, half, half, bullet, std::move(nudged), 0});
}

Spec swimmers() {
    Spec spec = fake_spec("water", 1, 24);
    spec.parameters.gait.locomotion_steps = 800;
    spec.actuation_range = 0.2;
    spec.environment.drag_normal = 1;
    spec.environment.drag_tangential = 0.1;
    spec.judge = [](const Life &life) {
        const bool viable = life.outcome == Outcome::viable;
        return Evaluation{
            viable ? life.displacement() : 0, {life.finish.x, life.finish.y}, viable ? 1.0 : 0.0};
    };
    return spec;
}

/// Real runs of seeds 1 … 3, evolved under these settings' own engine.
void evolve(const Spec &spec, const std::filesystem::path &runs) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        RunWriter writer(run_folder(runs, spec.name, seed), spec, seed, fake_sources());
        RunState state = begin(spec, seed);
        writer.before_generation(state, "");
        run(
            spec, seed, 2, state, [&](const Generation &g) { writer.observe(g); },
            [&](const RunState &now) { writer.before_generation(now, ""); });
        writer.finish();
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(change_is_relative_to_the_way_and_to_one_cell_for_those_that_hardly_move) {
    const WitnessRow far = row_of(moved(20), moved(19), moved(26));
    BOOST_TEST(far.half_change == 0.05, tt::tolerance(1e-12));
    BOOST_TEST(far.bullet_change == 0.3, tt::tolerance(1e-12));
    BOOST_TEST(row_of(moved(0.01), moved(0.05), moved(0)).half_change == 0.04, tt::tolerance(1e-12));
    BOOST_TEST(row_of(moved(0), moved(0), moved(0)).bullet_change == 0);
}

BOOST_AUTO_TEST_CASE(a_champion_that_the_time_step_made_is_flagged) {
    const std::string flag = "integration exploit";
    BOOST_TEST(row_of(moved(20), moved(18.01), moved(0)).flag == "");
    BOOST_TEST(row_of(moved(20), moved(17.99), moved(20)).flag == flag);
    BOOST_TEST(row_of(moved(20), moved(22.01), moved(20)).flag == flag);
    const WitnessRow burst = row_of(moved(0.01), moved(0, Outcome::exploded), moved(20));
    BOOST_TEST(burst.flag == flag);
    BOOST_TEST(burst.half_outcome == "exploded");
}

BOOST_AUTO_TEST_CASE(a_champion_that_moves_while_its_muscles_hold_still_is_flagged) {
    const auto flag = [](double half, double unrest) {
        return witness_row(fake_spec("water", 1, 1), champion, 7,
                           {moved(20), moved(half), moved(20), moved(20), {}, unrest})
            .flag;
    };
    BOOST_TEST(flag(20, 2.99) == "");
    BOOST_TEST(flag(20, 3.01) == "perpetual motion");
    BOOST_TEST(flag(10, 3.01) == "integration exploit");
}

BOOST_AUTO_TEST_CASE(bodies_pressed_on_themselves_come_to_rest_once_their_muscles_hold_still) {
    // Champions of a law of self-collision that fed them: they swam 6 cells by trembling at up to 13 cells/t.u.
    // Now they hold a posture, and their way does not depend on the time step.
    for (const char *name : {"arch", "knot"}) {
        const auto folder = std::filesystem::path(PLANULA_SOURCE_DIR) / "tests/golden/tremblers" / name;
        const Genome genome = genome_of(read_table<GenomeRow>(folder));
        Conditions conditions{.actuation = Actuation::grn, .environment = specimens::water()};
        conditions.parameters = specimens::turning(); // as when they were champions
        conditions.actuation_range = conditions.parameters.water.actuation_range_aquatic;
        BOOST_TEST(held_unrest(genome, conditions) < 0.05, name);
        const double way = live(genome, conditions).displacement();
        BOOST_TEST(way > 0.1, name);
        conditions.refinement = 2;
        BOOST_TEST(live(genome, conditions).displacement() == way, tt::tolerance(0.02));
    }
}

BOOST_AUTO_TEST_CASE(a_body_that_explodes_has_the_highest_unrest) {
    Conditions conditions{.actuation_range = 0.4, .environment = specimens::water()};
    conditions.parameters.development.time_step = 0.02;
    const Genome genome = specimens::lump_genome(Actuation::oscillator, 6);
    BOOST_TEST(live(genome, conditions).outcome == Outcome::exploded);
    BOOST_TEST(held_unrest(genome, conditions) == 50);
}

BOOST_AUTO_TEST_CASE(movement_by_muscles_is_not_unrest) {
    // A swimmer stirs to the end of its life, and no longer once its muscles hold still.
    const Conditions conditions{.actuation_range = 0.4, .environment = specimens::water()};
    const Genome genome = specimens::lump_genome(Actuation::oscillator, 6);
    std::vector<Vec2d> before;
    double beating = 0;
    live(genome, conditions, {.move = [&](int, std::span<const Vec2d> nodes, std::span<const double>) {
             for (std::size_t i = 0; i < before.size(); ++i)
                 beating = std::max(beating, length(nodes[i] - before[i]) /
                                                 conditions.parameters.development.time_step);
             before.assign(nodes.begin(), nodes.end());
         }});
    BOOST_TEST(beating > 1);
    BOOST_TEST(held_unrest(genome, conditions) < 0.05);
}

BOOST_AUTO_TEST_CASE(the_cause_is_chaos_before_the_step_before_the_engine) {
    const auto cause = [](double half, double eighth, const Life &bullet, std::vector<Life> nudged) {
        return witness_row(fake_spec("water", 1, 1), champion, 7,
                           {moved(20), moved(half), moved(eighth), bullet, std::move(nudged), 0})
            .cause;
    };
    const std::vector<Life> steady{moved(20.5), moved(19.5)}, wild{moved(20), moved(26)};
    BOOST_TEST(cause(19, 19, moved(21), wild) == ""); // nothing to explain
    BOOST_TEST(cause(15, 20, moved(20), steady) == "time step");
    BOOST_TEST(cause(19, 15, moved(15), {moved(15)}) == "time step"); // Bullet sides with the finest step
    BOOST_TEST(cause(19, 20, moved(30), steady) == "engine");
    BOOST_TEST(cause(15, 20, moved(20), wild) == "chaos");
    BOOST_TEST(cause(20, 20, moved(30), {moved(20), moved(0, Outcome::exploded)}) == "chaos");
    BOOST_TEST(cause(20, 20, moved(0, Outcome::never_settled), steady) == "engine");
    // A nudge is measured where it is made: at the finest step.
    const WitnessRow row =
        witness_row(fake_spec("water", 1, 1), champion, 7,
                    {moved(20), moved(15), moved(10), moved(20), {moved(10.5), moved(9)}, 0});
    BOOST_TEST(row.nudged_change == 0.1, tt::tolerance(1e-12));
    BOOST_TEST(row.eighth_change == 0.5, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_life_that_is_not_viable_has_lost_the_whole_distance_and_has_no_place) {
    const WitnessRow row = row_of(moved(20), moved(20), moved(20, Outcome::never_settled));
    BOOST_TEST(row.bullet_outcome == "never_settled");
    BOOST_TEST(row.bullet_displacement == 0);
    BOOST_TEST(row.bullet_change == 1);
    BOOST_TEST(!row.bullet_rest_height.has_value());
    BOOST_TEST(row.rest_height.value() == 0.5);
}

BOOST_AUTO_TEST_CASE(a_setting_is_summed_up_and_correlated_from_three_champions_on) {
    std::vector<WitnessRow> rows{row_of(moved(10), moved(10), moved(30)),
                                 row_of(moved(20), moved(21), moved(20))};
    const Spec spec = fake_spec("water", 1, 1);
    BOOST_TEST(!engine_row(spec, rows).rank_correlation.has_value());
    rows.push_back(row_of(moved(40), moved(20), moved(10)));
    const EngineRow row = engine_row(spec, rows);
    BOOST_TEST(row.champions == 3);
    BOOST_TEST(row.rank_correlation.value() == -1);
    BOOST_TEST(row.half_change_median.value() == 0.05, tt::tolerance(1e-12));
    BOOST_TEST(row.half_change_largest.value() == 0.5);
    BOOST_TEST(row.bullet_change_median.value() == 0.75);
    BOOST_TEST(row.bullet_change_largest.value() == 2);
    BOOST_TEST(row.flagged == 1);
    BOOST_TEST(row.cause_chaos == 0);
    BOOST_TEST(row.cause_time_step == 1);
    BOOST_TEST(row.cause_engine == 1);
    BOOST_TEST(row.height_change_largest.value() == 0);

    const EngineRow nobody = engine_row(spec, {});
    BOOST_TEST(nobody.champions == 0);
    BOOST_TEST(!nobody.half_change_median.has_value());
}

BOOST_AUTO_TEST_CASE(champions_are_witnessed_the_same_on_any_number_of_threads) {
    const TemporaryFolder folder;
    const std::vector<Spec> settings{swimmers(), fake_spec("land", 1, 24)};
    evolve(settings[0], folder / "runs");
    witness(settings, {folder / "runs"}, folder / "one", 1);
    witness(settings, {folder / "runs"}, folder / "three", 3);
    for (const char *table : {"witness.csv", "engines.csv"})
        BOOST_TEST(read_bytes(folder.path() / "one" / table) == read_bytes(folder.path() / "three" / table),
                   table);

    const auto rows = read_table<WitnessRow>(folder / "one");
    BOOST_REQUIRE(rows.size() == 3u);
    for (const WitnessRow &row : rows) {
        const auto champions = read_table<ChampionRow>(
            run_folder(folder / "runs", "water", static_cast<std::uint64_t>(row.seed)));
        BOOST_TEST(row.displacement == champions.back().displacement);
        BOOST_TEST(row.half_outcome == "viable");
        BOOST_TEST(row.half_displacement != row.displacement);
        BOOST_TEST(row.bullet_displacement != row.displacement);
        BOOST_TEST(row.nudged_change > 0);
        BOOST_TEST(row.nudged_change < 0.1);
    }
    const auto engines = read_table<EngineRow>(folder / "one");
    BOOST_REQUIRE(engines.size() == 1u);
    BOOST_TEST(engines[0].setting == "water");
    BOOST_TEST(engines[0].champions == 3);
}

BOOST_AUTO_TEST_CASE(a_champion_of_bullet_must_have_its_life_in_bullet) {
    const TemporaryFolder folder;
    std::vector<Spec> settings{swimmers()};
    settings[0].engine = "bullet";
    evolve(settings[0], folder / "runs");
    witness(settings, {folder / "runs"}, folder / "data", 2);
    for (const WitnessRow &row : read_table<WitnessRow>(folder / "data"))
        BOOST_TEST(row.bullet_displacement == row.fitness);
    // Under another engine there is no such run.
    settings[0].engine = "native";
    BOOST_CHECK_THROW(witness(settings, {folder / "runs"}, folder / "data", 2), InputError);
}

BOOST_AUTO_TEST_CASE(a_champion_whose_life_is_not_the_recorded_one_is_refused) {
    const TemporaryFolder folder;
    const std::vector<Spec> settings{swimmers()};
    write_fake_run(folder / "runs", settings[0], 1, [](int, int) { return FakeLife{.moved = {3, 4}}; });
    const std::string said =
        message_of<InputError>([&] { witness(settings, {folder / "runs"}, folder / "data", 1); });
    BOOST_TEST(contains(said, "champions.csv: the best individual of 'water' moved 5 cells with 10 cells"),
               said);
    BOOST_TEST(contains(said, "the data are of another experiment or version"), said);
    BOOST_TEST(!std::filesystem::exists(folder / "data/engines.csv"));
    BOOST_TEST(
        contains(message_of<InputError>([&] { witness(settings, {folder / "none"}, folder / "data", 1); }),
                 "there is no run of this experiment below"));
}
