// SPDX-License-Identifier: MIT
#include "analysis/tables.h"

#include "core/analysis/fake_setting.h"
#include "tables/genome_table.h"

#include <boost/test/unit_test.hpp>
#include <set>

using namespace planula;
using boost::test_tools::tolerance;

namespace {

FakeLife life(int generation, int slot) {
    if (slot % 5 == 4) return {.cells = 2, .outcome = Outcome::too_small};
    return {.fitness = 1.0 + generation + slot, .moved = {1.0 * slot, 2.0 * generation}};
}

/// A setting read from the runs below a folder.
SettingRuns read_setting(const std::filesystem::path &folder, const Spec &spec) {
    SettingRuns setting = survey(std::span(&spec, 1), runs_in(folder)).front();
    for (const RecordedRun &run : setting.runs)
        setting.histories.push_back(read_history(run, setting.generations, 4, 1));
    return setting;
}

std::set<std::pair<int, double>> places(const std::vector<EndpointRow> &rows) {
    std::set<std::pair<int, double>> all;
    for (const EndpointRow &row : rows) all.insert({row.generation, row.x});
    return all;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_sample_depends_on_run_generation_and_slot_alone) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 20, 50), shorter = fake_spec("ns", 8, 50);
    write_fake_run(folder.path(), spec, 3, life);
    const auto whole = places(endpoint_rows(read_setting(folder.path(), spec), {"best", 0}, 0.2));
    const auto part = places(endpoint_rows(read_setting(folder.path(), shorter), {"median", 0}, 0.2));

    // The shorter history's sample is the beginning of the longer one's.
    std::set<std::pair<int, double>> beginning;
    for (const auto &place : whole)
        if (place.first < 8) beginning.insert(place);
    BOOST_TEST((part == beginning));

    // A larger share keeps whom a smaller one took.
    const auto more = places(endpoint_rows(read_setting(folder.path(), spec), {"best", 0}, 0.6));
    BOOST_TEST(std::includes(more.begin(), more.end(), whole.begin(), whole.end()));

    // 800 viable individuals, a fifth of them: four standard deviations are 45.
    BOOST_TEST(whole.size() > 115u);
    BOOST_TEST(whole.size() < 205u);
}

BOOST_AUTO_TEST_CASE(another_seed_draws_another_sample) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 10, 50);
    write_fake_run(folder.path(), spec, 1, life);
    write_fake_run(folder.path(), spec, 2, life);
    const SettingRuns setting = read_setting(folder.path(), spec);
    const auto a = places(endpoint_rows(setting, {"best", 0}, 0.2)),
               b = places(endpoint_rows(setting, {"best", 1}, 0.2));
    BOOST_TEST((a != b));
}

BOOST_AUTO_TEST_CASE(a_whole_sample_has_every_viable_individual_from_where_it_rested) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 2, 5);
    write_fake_run(folder.path(), spec, 1, life);
    const auto rows = endpoint_rows(read_setting(folder.path(), spec), {"best", 0}, 1);
    BOOST_REQUIRE(rows.size() == 8u);
    BOOST_TEST(rows[7].generation == 1);
    BOOST_TEST(rows[7].x == 3);
    BOOST_TEST(rows[7].y == 2);
    BOOST_TEST(rows[7].role == "best");
}

BOOST_AUTO_TEST_CASE(curves_have_the_mean_inside_its_interval) {
    const Spec spec = fake_spec("ns", 3, 5);
    const auto rows = curve_rows(fake_setting(spec, {1, 2, 6}), fake_analysis());
    BOOST_REQUIRE(rows.size() == 3u);
    BOOST_TEST(rows[2].generation == 2);
    BOOST_TEST(rows[2].runs == 3);
    BOOST_TEST(rows[2].mean == 3);
    BOOST_TEST(rows[2].low.value() >= 1);
    BOOST_TEST(rows[2].low.value() < 3);
    BOOST_TEST(rows[2].high.value() > 3);
    // Runs are resampled as wholes: equal generations have equal intervals.
    BOOST_TEST(rows[0].low.value() == rows[2].low.value());
}

BOOST_AUTO_TEST_CASE(too_few_runs_have_no_interval) {
    const Spec spec = fake_spec("ns", 3, 5);
    Analysis analysis = fake_analysis();
    analysis.interval_runs = 4;
    const SettingRuns setting = fake_setting(spec, {1, 2, 6});
    BOOST_TEST(!curve_rows(setting, analysis)[0].low.has_value());
    BOOST_TEST(!shape_diversity_rows(setting, analysis)[0].high.has_value());
    BOOST_TEST(!entropy_row(setting, analysis).low.has_value());
    BOOST_TEST(entropy_row(setting, analysis).mean == 3);
}

BOOST_AUTO_TEST_CASE(shape_diversity_has_a_curve_and_both_its_ends_in_every_run) {
    const Spec spec = fake_spec("ns", 3, 5);
    SettingRuns setting = fake_setting(spec, {1, 2, 6});
    for (int i = 0; i < 3; ++i) setting.histories[0].generations[i].shape_diversity = 0.25 * (i + 1);
    const auto rows = shape_diversity_rows(setting, fake_analysis());
    BOOST_REQUIRE(rows.size() == 3u);
    BOOST_TEST(rows[1].generation == 1);
    BOOST_TEST(rows[1].mean == (0.5 + 2 + 6) / 3);
    BOOST_TEST(rows[1].low.value() < rows[1].mean);
    const auto runs = run_rows(setting);
    BOOST_TEST(runs[0].shape_diversity_first == 0.25);
    BOOST_TEST(runs[0].shape_diversity_last == 0.75);
}

BOOST_AUTO_TEST_CASE(heredity_is_the_median_of_the_runs_that_have_a_value) {
    const Spec spec = fake_spec("ns", 3, 5);
    SettingRuns setting = fake_setting(spec, {1, 2, 6});
    setting.histories[2].generations[1].heredity_fitness.reset();
    const auto rows = heredity_rows(setting);
    BOOST_REQUIRE(rows.size() == 3u);
    BOOST_TEST(rows[1].setting == "ns");
    BOOST_TEST(rows[1].generation == 1);
    BOOST_TEST(rows[1].runs == 3);
    BOOST_TEST(rows[1].heredity_fitness.value() == 1.5);
    BOOST_TEST(rows[1].near_best.value() == 2);
    BOOST_TEST(rows[2].heredity_fitness.value() == 2);
    BOOST_TEST(!rows[2].cyclic.has_value());
}

BOOST_AUTO_TEST_CASE(entropy_has_mean_and_median_of_the_runs) {
    const Spec spec = fake_spec("ns", 3, 5);
    const EntropyRow row = entropy_row(fake_setting(spec, {1, 2, 6}), fake_analysis());
    BOOST_TEST(row.mean == 3);
    BOOST_TEST(row.median == 2);
    BOOST_TEST(row.runs == 3);
}

BOOST_AUTO_TEST_CASE(outcomes_are_shares_of_all_runs) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 3, 5);
    write_fake_run(folder.path(), spec, 1, life);
    write_fake_run(folder.path(), spec, 2, [](int, int) { return FakeLife{}; });
    const auto rows = outcome_rows(read_setting(folder.path(), spec));
    BOOST_REQUIRE(rows.size() == 2u);
    BOOST_TEST(rows[1].generation == 2);
    BOOST_TEST(rows[1].viable == 0.9, tolerance(1e-12));
    BOOST_TEST(rows[1].too_small == 0.1, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_history_of_one_generation_has_its_outcomes_once) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 1, 5);
    write_fake_run(folder.path(), spec, 1, life);
    BOOST_TEST(outcome_rows(read_setting(folder.path(), spec)).size() == 1u);
}

BOOST_AUTO_TEST_CASE(the_best_genome_is_of_the_best_run_and_comes_back) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 2, 5);
    write_fake_run(folder.path(), spec, 1, life);
    write_fake_run(folder.path(), spec, 2, [](int, int) { return FakeLife{.fitness = 100, .cells = 33}; });
    const SettingRuns setting = read_setting(folder.path(), spec);
    std::vector<GenomeRow> genes;
    for (const BestGenomeRow &row : best_genome_rows(setting)) {
        if (row.rank != 1) continue;
        BOOST_TEST(row.seed == 2);
        BOOST_TEST(row.fitness == 100);
        BOOST_TEST(row.cells == 33);
        genes.push_back({row.kind, row.id, row.from, row.to, row.value, row.recurrent});
    }
    BOOST_TEST((genome_of(genes) == read_champion_genome(setting.runs[1], 2)));
    const auto chosen = representatives(setting);
    BOOST_TEST(chosen[0].role == std::string("best"));
    BOOST_TEST(chosen[0].run == 1u);
    BOOST_TEST(chosen[1].role == std::string("median"));
    BOOST_TEST(chosen[1].run == 0u);
}

BOOST_AUTO_TEST_CASE(the_best_three_runs_are_shown_the_fittest_first) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 2, 5);
    for (const std::uint64_t seed : {1, 2, 3, 4})
        write_fake_run(folder.path(), spec, seed, [seed](int, int) {
            constexpr double fitness[] = {7, 1, 9, 7};
            return FakeLife{.fitness = fitness[seed - 1]};
        });
    std::vector<std::pair<int, std::int64_t>> shown;
    for (const BestGenomeRow &row : best_genome_rows(read_setting(folder.path(), spec)))
        if (shown.empty() || shown.back().first != row.rank) shown.push_back({row.rank, row.seed});
    BOOST_TEST((shown == std::vector<std::pair<int, std::int64_t>>{{1, 3}, {2, 1}, {3, 4}}));
}

BOOST_AUTO_TEST_CASE(the_archive_shown_is_the_best_runs_and_ends_with_the_history) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("ns", 6, 5, "novelty"), shorter = fake_spec("ns", 4, 5, "novelty");
    write_fake_run(folder.path(), spec, 1, life);
    const auto rows = archive_point_rows(read_setting(folder.path(), shorter));
    BOOST_REQUIRE(rows.size() == 4u);
    BOOST_TEST(rows[3].generation == 3);
    BOOST_TEST(rows[3].x == 3);
    BOOST_TEST(rows[3].y.value() == 6);
    const TemporaryFolder other;
    const Spec without = fake_spec("ns", 6, 5);
    write_fake_run(other.path(), without, 1, life);
    BOOST_TEST(archive_point_rows(read_setting(other.path(), without)).empty());
}

BOOST_AUTO_TEST_CASE(a_settings_world_is_told_by_its_ground) {
    Spec spec = fake_spec("ns", 2, 5);
    const SettingRuns setting = fake_setting(spec, {1, 2});
    BOOST_TEST(setting_row(setting).world == "aquatic");
    spec.environment.has_ground = true;
    BOOST_TEST(setting_row(setting).world == "terrestrial");
    BOOST_TEST(setting_row(setting).actuation == "oscillator");
    BOOST_TEST(setting_row(setting).runs == 2);
}

BOOST_AUTO_TEST_CASE(a_settings_world_is_told_by_its_numbers_and_where_they_are_from) {
    Spec spec = fake_spec("ns", 2, 5);
    spec.environment.drag_normal = 8;
    spec.environment.gravity = 2;
    spec.world_sources = {{"gravity", "gravity"}};
    const SettingRuns setting = fake_setting(spec, {1, 2});
    const auto find = [&](const std::string &quantity) {
        for (const WorldRow &row : world_rows(setting))
            if (row.quantity == quantity) return row;
        throw std::runtime_error("no " + quantity);
    };
    BOOST_TEST(find("drag normal").value.value() == 8);
    BOOST_TEST(find("drag normal").unit == "mass/cell²");
    BOOST_TEST(find("drag normal").parameter == "");
    BOOST_TEST(find("gravity").value.value() == 2);
    BOOST_TEST(find("gravity").parameter == "gravity");
    BOOST_TEST(find("flow x").value.value() == 0);
    BOOST_TEST(!find("ground points").value.has_value());
    spec.environment.has_ground = true;
    BOOST_TEST(find("ground points").value.value() == 0);
    spec.environment.ground = {{0, 0}, {1, 1}};
    BOOST_TEST(find("ground points").value.value() == 2);
}

BOOST_AUTO_TEST_CASE(a_small_run_gives_a_larger_share_of_its_end_points) {
    Spec spec;
    spec.parameters.neat.population = 40;
    SettingRuns setting;
    setting.spec = &spec;
    setting.generations = 10;
    Analysis analysis = fake_analysis();
    analysis.sample_share = 0.01;
    analysis.sample_least = 100;
    BOOST_TEST(sampled_share(setting, analysis) == 0.25);
    analysis.sample_least = 1000;
    BOOST_TEST(sampled_share(setting, analysis) == 1);
    setting.generations = 2000;
    BOOST_TEST(sampled_share(setting, analysis) == 0.0125);
    setting.generations = 20000;
    BOOST_TEST(sampled_share(setting, analysis) == 0.01);
}
