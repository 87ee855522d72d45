// SPDX-License-Identifier: MIT
#include "analysis/survey.h"

#include "base/error.h"
#include "core/analysis/fake_setting.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

FakeLife life(int generation, int slot) { return {.fitness = 1.0 + generation + slot}; }

} // namespace

BOOST_AUTO_TEST_CASE(the_median_run_is_the_best_one_below_the_median) {
    // Ranks from 0: the 11th of 20 (decision 0015).
    BOOST_TEST(rank_below_median(20) == 10u);
    BOOST_TEST(rank_below_median(2) == 1u);
    BOOST_TEST(rank_below_median(3) == 2u);
    BOOST_TEST(rank_below_median(4) == 2u);
    BOOST_TEST(rank_below_median(5) == 3u);
    BOOST_TEST(rank_below_median(1) == 0u);
}

BOOST_AUTO_TEST_CASE(runs_are_ranked_by_fitness_and_equals_by_seed) {
    const Spec spec = fake_spec("ns", 2, 3);
    const SettingRuns setting = fake_setting(spec, {3, 5, 5, 1, 9});
    BOOST_TEST((ranking(setting) == std::vector<std::size_t>{4, 1, 2, 0, 3}));
}

BOOST_AUTO_TEST_CASE(runs_that_are_too_short_are_left_out_and_reported) {
    const TemporaryFolder folder;
    for (const auto &[seed, generations] : {std::pair{1, 5}, {2, 3}, {3, 4}})
        write_fake_run(folder.path(), fake_spec("ns", generations, 3), static_cast<std::uint64_t>(seed),
                       life);
    const std::vector<Spec> settings{fake_spec("ns", 4, 3), fake_spec("neat", 9, 3)};
    std::vector<std::string> told;
    const auto found = survey(
        settings, {.folder = folder.path(), .tell = [&](const std::string &line) { told.push_back(line); }});
    BOOST_TEST(found.at(0).generations == 4);
    BOOST_REQUIRE(found.at(0).runs.size() == 2u);
    BOOST_TEST(found.at(0).runs[0].seed == 1);
    BOOST_TEST(found.at(0).runs[1].seed == 3);
    BOOST_TEST(found.at(1).generations == 0);
    BOOST_TEST(found.at(1).runs.empty());
    BOOST_TEST(told == std::vector({"left out: " + (folder / "ns/seed-002").string() +
                                        ": 3 generations, where 4 are asked for",
                                    "left out: the setting neat: there is no run of it in " +
                                        (folder / "neat").string()}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(only_the_chosen_seeds_are_taken_and_missing_ones_reported) {
    const TemporaryFolder folder;
    for (const std::uint64_t seed : {1, 2, 3})
        write_fake_run(folder.path(), fake_spec("ns", 2, 3), seed, life);
    const std::vector<Spec> settings{fake_spec("ns", 2, 3)};
    std::vector<std::string> told;
    const auto found =
        survey(settings, {.folder = folder.path(), .seeds = {3, 7, 1}, .tell = [&](const std::string &line) {
                              told.push_back(line);
                          }});
    BOOST_REQUIRE(found.at(0).runs.size() == 2u);
    BOOST_TEST(found.at(0).runs[0].seed == 1);
    BOOST_TEST(found.at(0).runs[1].seed == 3);
    BOOST_TEST(told == std::vector{"missing: " + (folder / "ns/seed-007").string()},
               boost::test_tools::per_element());
    BOOST_CHECK_THROW(survey(settings, {.folder = folder.path(), .seeds = {7}}), InputError);
}

BOOST_AUTO_TEST_CASE(a_run_of_another_identity_is_left_out_and_reported) {
    const TemporaryFolder folder;
    write_fake_run(folder.path(), fake_spec("ns", 2, 3), 1, life);
    write_fake_run(folder.path(), fake_spec("ns", 2, 30), 2, life);
    const std::vector<Spec> settings{fake_spec("ns", 2, 30)};
    std::vector<std::string> told;
    const auto found = survey(
        settings, {.folder = folder.path(), .tell = [&](const std::string &line) { told.push_back(line); }});
    BOOST_TEST(found.at(0).runs.size() == 1u);
    BOOST_TEST(told == std::vector{"left out: " + (folder / "ns/seed-001").string() +
                                   ": another run: parameter population: recorded with 3, asked for with 30"},
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(no_run_at_all_is_an_error) {
    const TemporaryFolder folder;
    const std::vector<Spec> settings{fake_spec("ns", 2, 30)};
    BOOST_TEST(message_of<InputError>([&] { survey(settings, runs_in(folder.path())); }) ==
               "there is no run of this experiment below " + folder.path().string() +
                   " that has 2 generations");
}
