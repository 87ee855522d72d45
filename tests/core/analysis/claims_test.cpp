// SPDX-License-Identifier: MIT
#include "analysis/claims.h"

#include "core/analysis/fake_setting.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using boost::test_tools::tolerance;

namespace {

const std::vector<double> low{1, 2, 3, 4, 5, 6}, high{11, 12, 13, 14, 15, 16},
    mixed{5.5, 2.5, 4.5, 3.5, 1.5, 6.5};

ClaimRow judge(const Claim &claim, const std::vector<double> &ns, const std::vector<double> &neat,
               const Analysis &analysis = fake_analysis(), int generations = 10, int population = 10) {
    const Spec a = fake_spec("ns", generations, population), b = fake_spec("neat", generations, population);
    const std::vector<SettingRuns> settings{fake_setting(a, ns), fake_setting(b, neat)};
    return judge_claim(claim, analysis, settings);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_clear_difference_is_reproduced_with_effect_interval_and_p) {
    const ClaimRow row = judge(fake_claim("best_at_generation", "greater"), high, low);
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.effect_name == "A12");
    BOOST_TEST(row.effect.value() == 1);
    BOOST_TEST(row.low.value() == 1);
    // Six against six without overlap: 2 / choose(12, 6).
    BOOST_TEST(row.p.value() == 2.0 / 924, tolerance(1e-12));
    BOOST_TEST(row.generation == 10);
    BOOST_TEST(row.at_generation == 10);
    BOOST_TEST(row.runs_a == 6);
    BOOST_TEST(row.runs_b == 6);
    BOOST_TEST(row.note == "");
    BOOST_TEST(judge(fake_claim("best_at_generation", "greater"), low, high).verdict == "contradicted");
    BOOST_TEST(judge(fake_claim("best_at_generation", "greater"), low, mixed).verdict == "inconclusive");
    BOOST_TEST(judge(fake_claim("best_at_generation", "no_difference"), low, mixed).verdict == "reproduced");
}

BOOST_AUTO_TEST_CASE(every_rank_test_looks_at_its_own_measure) {
    for (const char *test : {"size_entropy", "fitness_spread", "direction", "side_switches"}) {
        BOOST_TEST(judge(fake_claim(test, "greater"), high, low).verdict == "reproduced", test);
        BOOST_TEST(judge(fake_claim(test, "less"), high, low).verdict == "contradicted", test);
    }
}

BOOST_AUTO_TEST_CASE(data_that_end_early_leave_a_claim_open_with_its_value) {
    Analysis analysis = fake_analysis();
    analysis.design.generations = 2000;
    analysis.design.seeds = 20;
    analysis.design.population = 300;
    const ClaimRow row = judge(fake_claim("best_at_generation", "greater"), high, low, analysis);
    BOOST_TEST(row.verdict == "open");
    BOOST_TEST(row.effect.value() == 1);
    BOOST_TEST(row.generation == 2000);
    BOOST_TEST(row.at_generation == 10);
    BOOST_TEST(row.note ==
               "data end after 10 of 2000 generations; 6 of 20 runs of ns; population 10 of 300 in ns; "
               "6 of 20 runs of neat; population 10 of 300 in neat");
}

BOOST_AUTO_TEST_CASE(a_claim_about_an_early_generation_is_decided_by_early_data) {
    Analysis analysis = fake_analysis();
    analysis.design.generations = 2000;
    Claim claim = fake_claim("best_at_generation", "greater");
    claim.generation = 8;
    const ClaimRow row = judge(claim, high, low, analysis);
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.at_generation == 8);
}

BOOST_AUTO_TEST_CASE(a_setting_without_runs_leaves_a_claim_open_without_value) {
    const ClaimRow row = judge(fake_claim("size_entropy", "greater"), high, {});
    BOOST_TEST(row.verdict == "open");
    BOOST_TEST(!row.effect.has_value());
    BOOST_TEST(!row.p.has_value());
    BOOST_TEST(row.at_generation == 0);
    BOOST_TEST(row.runs_a == 6);
    BOOST_TEST(row.runs_b == 0);
    BOOST_TEST(row.note == "no runs of neat");
    Analysis wider = fake_analysis();
    wider.design.population = 300;
    BOOST_TEST(judge(fake_claim("size_entropy", "greater"), high, {}, wider).note ==
               "population 10 of 300 in ns; no runs of neat");
}

BOOST_AUTO_TEST_CASE(single_runs_can_be_compared) {
    const ClaimRow row = judge(fake_claim("best_at_generation", "greater"), {2}, {1});
    BOOST_TEST(row.verdict == "open");
    BOOST_TEST(row.p.value() == 1);
}

BOOST_AUTO_TEST_CASE(the_best_runs_are_counted_across_both_settings) {
    Claim claim = fake_claim("top_runs");
    claim.count = 3;
    ClaimRow row = judge(claim, {9, 8, 7, 1, 1, 1}, {6, 5, 4, 3, 2, 1});
    BOOST_TEST(row.effect.value() == 3);
    BOOST_TEST(row.verdict == "reproduced");
    // choose(6, 3) / choose(12, 3)
    BOOST_TEST(row.p.value() == 20.0 / 220, tolerance(1e-12));
    row = judge(claim, {9, 8, 1, 1, 1, 1}, {8.5, 5, 4, 3, 2, 1});
    BOOST_TEST(row.effect.value() == 2);
    BOOST_TEST(row.verdict == "inconclusive");
    BOOST_TEST(judge(claim, {9, 1, 1, 1, 1, 1}, {8, 7, 6, 5, 4, 3}).verdict == "contradicted");
}

BOOST_AUTO_TEST_CASE(a_tie_among_the_best_speaks_against_the_claim) {
    Claim claim = fake_claim("top_runs");
    claim.count = 1;
    BOOST_TEST(judge(claim, {9, 1, 1, 1, 1, 1}, {9, 1, 1, 1, 1, 1}).effect.value() == 0);
}

BOOST_AUTO_TEST_CASE(a_mean_is_ahead_in_the_share_of_generations_that_it_is) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, high), fake_setting(b, low)};
    Claim claim = fake_claim("mean_ahead");
    claim.level = 1;
    BOOST_TEST(judge_claim(claim, fake_analysis(), settings).verdict == "reproduced");

    // In three of ten generations the means are the other way round, by more than chance among runs.
    for (RunHistory &history : settings[0].histories)
        for (int generation = 0; generation < 3; ++generation) history.best[generation] = -1;
    const ClaimRow row = judge_claim(claim, fake_analysis(), settings);
    BOOST_TEST(row.effect.value() == 0.7, tolerance(1e-12));
    BOOST_TEST(row.high.value() == 0.7, tolerance(1e-12));
    BOOST_TEST(row.verdict == "contradicted");
    claim.level = 0.5;
    BOOST_TEST(judge_claim(claim, fake_analysis(), settings).verdict == "reproduced");

    // Where the runs overlap, a share short of the level decides nothing.
    claim.level = 1;
    const std::vector<SettingRuns> close{fake_setting(a, {1, 2, 3, 4, 5, 5.9}), fake_setting(b, low)};
    BOOST_TEST(judge_claim(claim, fake_analysis(), close).verdict == "inconclusive");
}

BOOST_AUTO_TEST_CASE(gaits_that_do_not_last_are_counted_against_the_originals) {
    const Spec a = fake_spec("ns", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, high)};
    Claim claim = fake_claim("cyclic");
    claim.b = "";
    claim.level = 0.05, claim.count = 1;
    // Every other one glides.
    const auto stop = [&](int runs) {
        for (int run = 0; run < runs; ++run) {
            ChampionRow &champion = settings[0].histories[run].after.at(10).champion;
            (run % 2 ? champion.late_share : champion.late_actuation) = 0.01;
        }
        return judge_claim(claim, fake_analysis(), settings);
    };
    BOOST_TEST(stop(0).verdict == "reproduced");
    BOOST_TEST(stop(1).verdict == "reproduced");
    const ClaimRow some = stop(3);
    BOOST_TEST(some.effect.value() == 3);
    BOOST_TEST(some.verdict == "inconclusive");
    const ClaimRow all = stop(6);
    // Six of six beside one of six: choose(6, 1) ways of choose(12, 7).
    BOOST_TEST(all.p.value() == 6.0 / 792, tolerance(1e-12));
    BOOST_TEST(all.verdict == "contradicted");
    BOOST_TEST(all.setting_b == "");
    BOOST_TEST(all.runs_b == 0);
}

BOOST_AUTO_TEST_CASE(the_best_must_be_as_and_more_elongated_than_the_rest) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, {9, 8, 1, 1, 1, 1}),
                                      fake_setting(b, {7, 6, 5, 4, 3, 2})};
    Claim claim = fake_claim("elongated");
    claim.count = 2;
    settings[0].histories[0].after.at(10).champion.elongation = 6;
    ClaimRow row = judge_claim(claim, fake_analysis(), settings);
    BOOST_TEST(row.effect.value() == 1);
    BOOST_TEST(row.verdict == "inconclusive");
    settings[0].histories[1].after.at(10).champion.elongation = 5;
    row = judge_claim(claim, fake_analysis(), settings);
    BOOST_TEST(row.effect.value() == 2);
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.p.value() < 0.05);
}

BOOST_AUTO_TEST_CASE(settings_of_different_length_meet_at_the_shorter) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 7, 10);
    const std::vector<SettingRuns> settings{fake_setting(a, high), fake_setting(b, low)};
    const ClaimRow row = judge_claim(fake_claim("size_entropy", "greater"), fake_analysis(), settings);
    BOOST_TEST(row.at_generation == 7);
    BOOST_TEST(row.note == "data end after 7 of 10 generations");
}
