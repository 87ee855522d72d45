// SPDX-License-Identifier: MIT
#include "analysis/sensitivity.h"

#include "base/error.h"
#include "core/record/fake_run.h"
#include "evaluation/live.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;
namespace tt = boost::test_tools;

namespace {

const ParameterRow &row_of(std::string_view name) {
    for (const ParameterRow &row : parameter_rows())
        if (row.name == name) return row;
    throw std::runtime_error("no such parameter");
}

/// Brief lives in water.
Spec swimmers(int population = 24) {
    Spec spec = fake_spec("water", 2, population);
    spec.parameters.gait.locomotion_steps = 400;
    spec.actuation_range = 0.2;
    spec.environment.drag_normal = 1;
    spec.environment.drag_tangential = 0.1;
    return spec;
}

/// Fake runs of seeds 1 … 3; their genomes are real.
std::filesystem::path three_runs(const TemporaryFolder &folder, const Spec &spec) {
    for (const std::uint64_t seed : {1, 2, 3})
        write_fake_run(folder / "runs", spec, seed, [](int, int) { return FakeLife{}; });
    return folder / "runs";
}

} // namespace

BOOST_AUTO_TEST_CASE(a_sample_is_of_all_runs_and_the_same_each_time_with_its_own_lives) {
    const TemporaryFolder folder;
    const std::vector<Spec> settings{swimmers(), fake_spec("land", 2, 24)};
    const auto runs = three_runs(folder, settings[0]);
    const std::vector<Sample> one = draw_samples(settings, {runs}, 20, 1),
                              two = draw_samples(settings, {runs}, 20, 2);
    BOOST_REQUIRE(one.size() == 1u);
    BOOST_REQUIRE(two.size() == 1u);
    BOOST_TEST(one[0].spec == &settings[0]);
    BOOST_TEST(one[0].genomes.size() == 20u);
    BOOST_TEST((one[0].genomes == two[0].genomes));
    for (std::size_t i = 0; i < 20; ++i)
        BOOST_TEST((one[0].lives[i].finish == live(one[0].genomes[i], settings[0]).finish));

    // Seven runs' worth of chance against all being of one run.
    std::vector<double> first_weights;
    for (const Genome &genome : one[0].genomes) first_weights.push_back(genome.links.front().weight);
    const auto from = [&](std::uint64_t seed) {
        return std::any_of(first_weights.begin(), first_weights.end(), [&](double weight) {
            const Population run = fake_population(settings[0], seed);
            return std::any_of(run.genomes.begin(), run.genomes.end(),
                               [&](const Genome &genome) { return genome.links.front().weight == weight; });
        });
    };
    for (const std::uint64_t seed : {1, 2, 3}) BOOST_TEST(from(seed));
}

BOOST_AUTO_TEST_CASE(a_sample_larger_than_the_runs_has_every_individual_once) {
    const TemporaryFolder folder;
    const std::vector<Spec> settings{swimmers(4)};
    const auto runs = three_runs(folder, settings[0]);
    BOOST_TEST(draw_samples(settings, {runs}, 1000, 2).at(0).genomes.size() == 12u);
    BOOST_CHECK_THROW(draw_samples(settings, {folder / "none"}, 5, 1), InputError);
}

BOOST_AUTO_TEST_CASE(genomes_of_a_generation_that_was_not_kept_are_refused) {
    const TemporaryFolder folder;
    const auto drawn = [&](int generations) {
        std::vector<Spec> settings{swimmers(3)};
        settings[0].parameters.design.generations = generations;
        return draw_samples(settings, {folder / "runs"}, 3, 1).at(0).genomes.front().id;
    };
    Spec longer = swimmers(3);
    longer.parameters.design.generations = 30;
    write_fake_run(folder / "runs", longer, 1, [](int, int) { return FakeLife{}; });
    BOOST_TEST(drawn(30) == 29 * 3);
    BOOST_TEST(drawn(26) == 25 * 3);
    BOOST_TEST(contains(message_of<InputError>([&] { drawn(25); }),
                        "the genomes of generation 24 are not kept in a run of 30 generations"));
}

BOOST_AUTO_TEST_CASE(a_parameter_concerns_the_worlds_that_it_shapes) {
    Spec water = swimmers(), land = fake_spec("land", 1, 1);
    land.environment.has_ground = true;
    BOOST_TEST(concerns(row_of("drag_normal"), water));
    BOOST_TEST(!concerns(row_of("drag_normal"), land));
    BOOST_TEST(concerns(row_of("gravity"), land));
    BOOST_TEST(!concerns(row_of("gravity"), water));
    BOOST_TEST(concerns(row_of("tissue_stiffness"), water));
    BOOST_TEST(!concerns(row_of("path_interval"), water));
    BOOST_TEST(!concerns(row_of("survival_rate"), land));
}

BOOST_AUTO_TEST_CASE(a_number_that_a_world_states_counts_as_its_parameter) {
    Spec honey = swimmers();
    honey.environment.drag_normal = 8;
    BOOST_TEST(used(row_of("drag_normal"), honey) == 8);
    honey.world_sources = {{"drag normal", "drag_normal"}};
    BOOST_TEST(used(row_of("drag_normal"), honey) == honey.parameters.water.drag_normal);

    // What is taken from another parameter is that one's, in any world.
    honey.world_sources = {{"drag normal", "gravity"}};
    BOOST_TEST(concerns(row_of("gravity"), honey));
    BOOST_TEST(!concerns(row_of("drag_normal"), honey));
    BOOST_TEST(concerns(row_of("drag_tangential"), honey));

    // The range of actuation has a parameter for either world, of which one stands for a number.
    BOOST_TEST(concerns(row_of("actuation_range_aquatic"), honey));
    honey.environment.has_ground = true;
    BOOST_TEST(!concerns(row_of("actuation_range_aquatic"), honey));
    BOOST_TEST(used(row_of("actuation_range_terrestrial"), honey) == 0.2);
}

BOOST_AUTO_TEST_CASE(the_assumed_parameters_are_ours_and_of_lives) {
    const auto names = assumed_parameters();
    const auto has = [&](std::string_view name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    for (const char *name : {"gravity", "drag_normal", "spring_stiffness", "period_shortest", "time_step"})
        BOOST_TEST(has(name), name);
    for (const char *name : {"locomotion_steps", "add_node_rate", "bootstrap_resamples", "path_interval"})
        BOOST_TEST(!has(name), name);
}

BOOST_AUTO_TEST_CASE(a_varied_value_keeps_to_its_range_and_kind) {
    BOOST_TEST(varied(row_of("gravity"), 5, 0.5) == 2.5);
    BOOST_TEST(varied(row_of("node_speed_limit"), 9, 2) == 10);
    BOOST_TEST(varied(row_of("settle_limit"), 5, 0.5) == 3);
    BOOST_TEST(varied(row_of("drag_normal"), 500, 0.5) == 250); // stated beyond the range
    BOOST_TEST(varied(row_of("drag_normal"), 500, 2) == 500);
}

BOOST_AUTO_TEST_CASE(nothing_changes_with_the_same_value_and_none_is_viable_with_an_impossible_one) {
    const TemporaryFolder folder;
    const std::vector<Spec> settings{swimmers()};
    const Sample sample = draw_samples(settings, {three_runs(folder, settings[0])}, 40, 2).at(0);
    const SensitivityRow same = vary(sample, settings[0], row_of("spring_stiffness"), 2);
    BOOST_REQUIRE(same.viable_before > 0);
    BOOST_TEST(same.sampled == 40);
    BOOST_TEST(same.value == same.standard);
    BOOST_TEST(same.viable_after == same.viable_before);
    BOOST_TEST(same.ratio_low.value() == 1);
    BOOST_TEST(same.ratio_high.value() == 1);
    BOOST_TEST(same.best_ratio.value() == 1);
    BOOST_TEST(same.rank_correlation.value() == 1, tt::tolerance(1e-12));

    Spec nobody = settings[0];
    set_parameter(nobody.parameters, "minimum_cells", 1000);
    const SensitivityRow none = vary(sample, nobody, row_of("minimum_cells"), 2);
    BOOST_TEST(none.viable_after == 0);
    BOOST_TEST(!none.ratio_median.has_value());
    BOOST_TEST(none.best_ratio.value() == 0);
    BOOST_TEST(!none.rank_correlation.has_value());
}

BOOST_AUTO_TEST_CASE(weaker_muscles_move_less) {
    const TemporaryFolder folder;
    const std::vector<Spec> settings{swimmers()};
    const Sample sample = draw_samples(settings, {three_runs(folder, settings[0])}, 40, 2).at(0);
    Spec weak = settings[0];
    weak.actuation_range /= 2;
    const SensitivityRow row = vary(sample, weak, row_of("actuation_range_aquatic"), 2);
    BOOST_TEST(row.standard == 0.2);
    BOOST_TEST(row.value == 0.1);
    BOOST_TEST(row.viable_after == row.viable_before);
    BOOST_TEST(row.ratio_median.value() < 0.8);
    BOOST_TEST(row.ratio_median.value() > 0);
}
