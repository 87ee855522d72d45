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

BOOST_AUTO_TEST_CASE(runs_of_different_length_share_the_generations_that_all_have) {
    const TemporaryFolder folder;
    for (const auto &[seed, generations] : {std::pair{1, 5}, {2, 3}, {3, 4}})
        write_fake_run(folder.path(), fake_spec("ns", generations, 3), static_cast<std::uint64_t>(seed),
                       life);
    const std::vector<Spec> wide{fake_spec("ns", 9, 3), fake_spec("neat", 9, 3)},
        narrow{fake_spec("ns", 2, 3)};
    const auto found = survey(wide, folder.path());
    BOOST_TEST(found.at(0).generations == 3);
    BOOST_TEST(found.at(0).runs.size() == 3u);
    BOOST_TEST(found.at(1).generations == 0);
    BOOST_TEST(found.at(1).runs.empty());
    BOOST_TEST(survey(narrow, folder.path()).at(0).generations == 2);
}

BOOST_AUTO_TEST_CASE(a_run_of_another_population_is_refused) {
    const TemporaryFolder folder;
    write_fake_run(folder.path(), fake_spec("ns", 2, 3), 1, life);
    const std::vector<Spec> settings{fake_spec("ns", 2, 30)};
    BOOST_TEST(message_of<InputError>([&] { survey(settings, folder.path()); }) ==
               (folder / "ns/seed-001").string() + " has a population of 3, and the experiment one of 30");
}

BOOST_AUTO_TEST_CASE(no_run_at_all_is_an_error) {
    const TemporaryFolder folder;
    const std::vector<Spec> settings{fake_spec("ns", 2, 30)};
    BOOST_TEST(message_of<InputError>([&] { survey(settings, folder.path()); }) ==
               "there is no complete run below " + folder.path().string());
}
