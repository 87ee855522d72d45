// SPDX-License-Identifier: MIT
#include "analysis/density.h"

#include "core/analysis/fake_setting.h"
#include "experiment/sample.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using boost::test_tools::tolerance;

namespace {

SettingRuns read_setting(const std::filesystem::path &folder, const Spec &spec) {
    SettingRuns setting = survey(std::span(&spec, 1), runs_in(folder)).front();
    for (const RecordedRun &run : setting.runs)
        setting.histories.push_back(read_history(run, setting.generations, 4, 1));
    return setting;
}

/// Slot 0 is not viable; the others end at slot - 3 and a half, to the right of it every other generation.
FakeLife life(int generation, int slot) {
    if (slot == 0) return {.cells = 2, .outcome = Outcome::too_small};
    return {.fitness = 1.0 + slot, .moved = {(slot - 3.5) * (generation % 2 ? 1 : -1), 0}};
}

} // namespace

BOOST_AUTO_TEST_CASE(a_small_run_is_counted_whole) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 3, 5);
    write_fake_run(folder.path(), spec, 1, life);
    const auto rows = endpoint_density_rows(read_setting(folder.path(), spec), {"best", 0});
    // Ends at ±2.5, ±1.5, ±0.5 and ∓0.5; bins of 1/8 reach 5.
    BOOST_REQUIRE(rows.size() == 12u);
    for (const EndpointDensityRow &row : rows) {
        BOOST_TEST(row.generation_low == row.generation_high);
        BOOST_TEST(row.x_high - row.x_low == 0.125);
        BOOST_TEST(row.recorded == 1);
        BOOST_TEST(row.individuals == 1);
    }
    BOOST_TEST(rows[0].x_low == -0.5);
    BOOST_TEST(rows[3].x_low == 2.5);
    BOOST_TEST(rows[4].x_low == -2.5);
    BOOST_TEST(rows[4].generation_low == 1);
}

BOOST_AUTO_TEST_CASE(bins_become_wider_until_they_cover_all) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 130, 2);
    write_fake_run(folder.path(), spec, 1, [](int generation, int slot) {
        return FakeLife{.moved = {slot ? 50 : -1.5, 1.0 * generation}};
    });
    const auto rows = endpoint_density_rows(read_setting(folder.path(), spec), {"best", 0});
    // 3 generations a bin; 100 cells in 80 bins take bins of 2.
    BOOST_REQUIRE(rows.size() == 88u);
    BOOST_TEST(rows[0].x_low == -2);
    BOOST_TEST(rows[0].x_high == 0);
    BOOST_TEST(rows[1].x_low == 50);
    BOOST_TEST(rows[1].recorded == 3);
    BOOST_TEST(rows[2].generation_low == 3);
    BOOST_TEST(rows[87].generation_low == 129);
    BOOST_TEST(rows[87].generation_high == 129);
    BOOST_TEST(rows[87].recorded == 1);
}

BOOST_AUTO_TEST_CASE(a_sample_stands_for_all_individuals) {
    const TemporaryFolder folder;
    // Of generation 99 the sample holds a fifth.
    const Spec spec = fake_spec("ns", 100, 50);
    write_fake_run(folder.path(), spec, 1, [](int, int) { return FakeLife{.moved = {1, 0}}; });
    const auto rows = endpoint_density_rows(read_setting(folder.path(), spec), {"median", 0});
    BOOST_REQUIRE(rows.size() == 50u);
    double recorded = 0, individuals = 0;
    for (const EndpointDensityRow &row : rows) recorded += row.recorded, individuals += row.individuals;
    BOOST_TEST(rows[0].individuals == 100);
    BOOST_TEST(recorded < 3000);
    // 5000 individuals; four standard deviations of the estimate are 4·√Σ(1/share − 1)·50 < 400.
    BOOST_TEST(individuals > 4600);
    BOOST_TEST(individuals < 5400);
    BOOST_TEST(rows[0].role == "median");
}

BOOST_AUTO_TEST_CASE(fitness_is_shared_out_over_the_generations_of_a_bin_and_over_runs) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 61, 4);
    // Fitness 1, 2, 3, 4 with one seed; with the other all alike.
    write_fake_run(folder.path(), spec, 1, [](int, int slot) { return FakeLife{.fitness = slot + 1.0}; });
    write_fake_run(folder.path(), spec, 2, [](int, int) { return FakeLife{.fitness = 5}; });
    const auto rows = fitness_history_rows(read_setting(folder.path(), spec));
    BOOST_REQUIRE(rows.size() == 4u * 31);
    BOOST_TEST(rows[0].generation_high == 1);
    BOOST_TEST(rows[120].generation_low == 60);
    BOOST_TEST(rows[120].generation_high == 60);
    const auto last = fitness_share_rows(read_setting(folder.path(), spec));
    for (std::size_t i = 0; i < 4; ++i) {
        // Every generation is the same, so that each bin is the last generation's.
        BOOST_TEST(rows[i].share == last[i].share, tolerance(1e-12));
        BOOST_TEST(rows[120 + i].share == last[i].share, tolerance(1e-12));
        BOOST_TEST(rows[i].low == last[i].low);
    }
    BOOST_TEST(last[3].share == (0.5 + 1) / 2); // 3/4 and 1 of the highest, and all of the other run
}
