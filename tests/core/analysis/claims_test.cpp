// SPDX-License-Identifier: MIT
#include "analysis/claims.h"

#include "core/analysis/fake_setting.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using boost::test_tools::tolerance;

namespace {

const std::vector<double> low{1, 2, 3, 4, 5, 6}, high{11, 12, 13, 14, 15, 16},
    mixed{5.5, 2.5, 4.5, 3.5, 1.5, 6.5};

/// from, from + 1, …: `count` values
std::vector<double> values(double from, int count) {
    std::vector<double> result;
    for (int i = 0; i < count; ++i) result.push_back(from + i);
    return result;
}

/// An analysis planned with this many runs of each setting.
Analysis planned(int seeds) {
    Analysis analysis = fake_analysis();
    analysis.design.design.seeds = seeds;
    return analysis;
}

ClaimRow judge(const Claim &claim, const std::vector<double> &ns, const std::vector<double> &neat,
               const Analysis &analysis = fake_analysis(), int generations = 10, int population = 10) {
    const Spec a = fake_spec("ns", generations, population), b = fake_spec("neat", generations, population);
    const std::vector<SettingRuns> settings{fake_setting(a, ns), fake_setting(b, neat)};
    return judge_claim(claim, analysis, settings);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_calibrated_claim_is_judged_and_marked) {
    Claim claim = fake_claim("best_at_generation", "greater");
    BOOST_TEST(judge(claim, high, low).calibrated == 0);
    claim.calibrated = true;
    BOOST_TEST(judge(claim, high, low).calibrated == 1);
    BOOST_TEST(judge(claim, high, low).verdict == "reproduced");
}

BOOST_AUTO_TEST_CASE(a_clear_difference_is_reproduced_with_effect_interval_and_p) {
    const ClaimRow row = judge(fake_claim("best_at_generation", "greater"), high, low);
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.effect_name == "A12");
    BOOST_TEST(row.effect.value() == 1);
    BOOST_TEST(row.low.value() == 1);
    // Six against six without overlap: 2 / choose(12, 6).
    BOOST_TEST(row.p.value() == 2.0 / 924, tolerance(1e-12));
    BOOST_TEST(row.method == "exact");
    BOOST_TEST(!row.p_equivalence.has_value());
    BOOST_TEST(row.generation == 10);
    BOOST_TEST(row.at_generation == 10);
    BOOST_TEST(row.runs_a == 6);
    BOOST_TEST(row.runs_b == 6);
    BOOST_TEST(row.note == "");
    BOOST_TEST(judge(fake_claim("best_at_generation", "greater"), low, high).verdict == "contradicted");
    BOOST_TEST(judge(fake_claim("best_at_generation", "greater"), low, mixed).verdict == "inconclusive");
}

BOOST_AUTO_TEST_CASE(no_difference_is_not_reproduced_for_want_of_runs) {
    Claim claim = fake_claim("best_at_generation", "no_difference");
    claim.bound = 0.21;
    ClaimRow row = judge(claim, low, mixed);
    BOOST_TEST(row.p.value() > 0.6);
    BOOST_TEST(row.verdict == "inconclusive");
    BOOST_TEST(row.note == "of so few runs p of equivalence is at least 0.113");

    // Twenty similar values each: the difference is smaller than the bound. Twenty distant ones: it is larger.
    const auto twenty = values(1, 20);
    row = judge(claim, twenty, values(1.5, 20), planned(20));
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.p_equivalence.value() < 0.05);
    BOOST_TEST(row.p.value() > 0.5);
    BOOST_TEST(judge(claim, twenty, values(11, 20), planned(20)).verdict == "contradicted");
    row = judge(claim, twenty, values(4, 20), planned(20));
    BOOST_TEST(row.verdict == "inconclusive");
    BOOST_TEST(row.note == "");
}

BOOST_AUTO_TEST_CASE(too_few_runs_reproduce_nothing_and_the_note_says_so) {
    for (const char *test : {"best_at_generation", "size_entropy", "mean_ahead"})
        for (const char *expect : {"greater", "no_difference"}) {
            Claim claim = fake_claim(test, expect);
            claim.level = 1;
            const ClaimRow row = judge(claim, {1000}, {1}, planned(1));
            BOOST_TEST(row.verdict == "inconclusive", test);
            BOOST_TEST(row.note.starts_with("of so few runs p"), test);
        }
    BOOST_TEST(judge(fake_claim("best_at_generation", "greater"), {7, 8, 9}, {1, 2, 3}, planned(3)).note ==
               "of so few runs p is at least 0.1");
    for (const char *test : {"top_runs", "elongated"})
        for (const int count : {1, 2, 5}) {
            Claim claim = fake_claim(test);
            claim.count = count;
            BOOST_TEST(judge(claim, {1000}, {1}, planned(1)).verdict == "inconclusive");
            BOOST_TEST(judge(claim, {1}, {1000}, planned(1)).verdict == "inconclusive");
            BOOST_TEST(judge(claim, {1}, {1000}, planned(1)).note.starts_with("of so few runs p"));
        }
    Claim claim = fake_claim("cyclic");
    claim.level = 0.1, claim.bound = 0.25, claim.b = "";
    BOOST_TEST(judge(claim, {1000}, {}, planned(1)).verdict == "inconclusive");
    BOOST_TEST(judge(claim, {1000}, {}, planned(1)).note ==
               "of so few runs p of equivalence is at least 0.75");
}

BOOST_AUTO_TEST_CASE(tied_values_of_few_runs_are_not_significant) {
    // The normal approximation gives 0.047.
    const ClaimRow row = judge(fake_claim("best_at_generation", "greater"), {2, 2, 2}, {1, 1, 1}, planned(3));
    BOOST_TEST(row.p.value() == 0.1, tolerance(1e-12));
    BOOST_TEST(row.method == "exact");
    BOOST_TEST(row.verdict == "inconclusive");
}

BOOST_AUTO_TEST_CASE(an_interval_takes_runs) {
    Analysis analysis = fake_analysis();
    analysis.interval_runs = 7;
    for (const char *test : {"best_at_generation", "mean_ahead"}) {
        Claim claim = fake_claim(test, "greater");
        claim.level = 1;
        BOOST_TEST(judge(claim, high, low).low.has_value());
        BOOST_TEST(!judge(claim, high, low, analysis).low.has_value());
        BOOST_TEST(!judge(claim, high, low, analysis).high.has_value());
    }
}

BOOST_AUTO_TEST_CASE(runs_without_a_value_are_left_out_and_reported) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, high), fake_setting(b, low)};
    settings[0].histories[2].after.at(10).direction_resultant = std::nullopt;
    const ClaimRow row = judge_claim(fake_claim("direction", "greater"), fake_analysis(), settings);
    BOOST_TEST(row.note == "1 runs of ns have no such value");
    BOOST_TEST(row.p.value() == 2.0 / 462, tolerance(1e-12)); // five against six
    for (RunHistory &history : settings[1].histories) history.after.at(10).direction_resultant = std::nullopt;
    const ClaimRow none = judge_claim(fake_claim("direction", "greater"), fake_analysis(), settings);
    BOOST_TEST(none.verdict == "inconclusive");
    BOOST_TEST(!none.p.has_value());
}

BOOST_AUTO_TEST_CASE(p_values_are_corrected_over_all_claims_and_say_which_decides) {
    Analysis analysis = fake_analysis();
    std::vector<ClaimRow> rows{{.id = "1", .p = 0.01, .verdict = "reproduced"},
                               {.id = "2", .p = 0.9, .p_equivalence = 0.04, .verdict = "reproduced"},
                               {.id = "3", .verdict = "inconclusive"},
                               {.id = "4", .p = 0.04, .p_equivalence = 0.9, .verdict = "contradicted"},
                               {.id = "5", .p = 0.001, .verdict = "open"}};
    correct_claims(rows, analysis.significance);
    // Six p-values: 0.001, 0.01, 0.04, 0.04, 0.9, 0.9
    BOOST_TEST(rows[4].p_holm.value() == 0.006, tolerance(1e-12));
    BOOST_TEST(rows[0].p_holm.value() == 0.05, tolerance(1e-12));
    BOOST_TEST(rows[1].p_equivalence_holm.value() == 0.16, tolerance(1e-12));
    BOOST_TEST(rows[1].p_holm.value() == 1);
    BOOST_TEST(!rows[2].p_holm.has_value());
    BOOST_TEST(rows[0].decided_by == "p");
    BOOST_TEST(rows[1].decided_by == "p_equivalence");
    BOOST_TEST(rows[2].decided_by == "");
    BOOST_TEST(rows[3].decided_by == "p");
    BOOST_TEST(rows[4].decided_by == "");
    rows[0].p = 0.001;
    correct_claims(rows, analysis.significance);
    BOOST_TEST(rows[0].decided_by == "p_holm");
}

BOOST_AUTO_TEST_CASE(every_rank_test_looks_at_its_own_measure) {
    for (const char *test : {"size_entropy", "fitness_spread", "direction", "side_switches"}) {
        BOOST_TEST(judge(fake_claim(test, "greater"), high, low).verdict == "reproduced", test);
        BOOST_TEST(judge(fake_claim(test, "less"), high, low).verdict == "contradicted", test);
    }
}

BOOST_AUTO_TEST_CASE(data_that_end_early_leave_a_claim_open_with_its_value) {
    Analysis analysis = fake_analysis();
    analysis.design.design.generations = 2000;
    analysis.design.design.seeds = 20;
    analysis.design.neat.population = 300;
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
    analysis.design.design.generations = 2000;
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
    wider.design.neat.population = 300;
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
    // Twice choose(6, 3) / choose(12, 3): the best three of six and six say nothing.
    BOOST_TEST(row.p.value() == 40.0 / 220, tolerance(1e-12));
    BOOST_TEST(row.verdict == "inconclusive");
    BOOST_TEST(row.note == "of so few runs p is at least 0.182");
    claim.count = 5; // choose(6, 5) / choose(12, 5)
    row = judge(claim, {9, 8, 7, 6, 5, 1}, {4, 4, 4, 3, 2, 1});
    BOOST_TEST(row.p.value() == 12.0 / 792, tolerance(1e-12));
    BOOST_TEST(row.verdict == "reproduced");
    row = judge(claim, {9, 8, 1, 1, 1, 1}, {8.5, 5, 4, 3, 2, 1});
    BOOST_TEST(row.effect.value() == 2);
    BOOST_TEST(row.verdict == "inconclusive");
    BOOST_TEST(judge(claim, {1, 1, 1, 1, 1, 1}, {8, 7, 6, 5, 4, 3}).verdict == "contradicted");
}

BOOST_AUTO_TEST_CASE(a_tie_among_the_best_speaks_against_the_claim) {
    Claim claim = fake_claim("top_runs");
    claim.count = 1;
    BOOST_TEST(judge(claim, {9, 1, 1, 1, 1, 1}, {9, 1, 1, 1, 1, 1}).effect.value() == 0);
    // And for neither verdict: equal runs are inconclusive.
    claim.count = 5;
    BOOST_TEST(judge(claim, std::vector<double>(6, 7), std::vector<double>(6, 7)).verdict == "inconclusive");
}

BOOST_AUTO_TEST_CASE(a_mean_is_ahead_by_a_test_over_runs) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, high), fake_setting(b, low)};
    Claim claim = fake_claim("mean_ahead");
    claim.level = 1;
    ClaimRow row = judge_claim(claim, fake_analysis(), settings);
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.effect.value() == 1);
    BOOST_TEST(!row.p_equivalence.has_value());
    // 924 ways to share out twelve runs are more than 500 draws.
    BOOST_TEST(row.method == "drawn");
    Analysis more = fake_analysis();
    more.resamples = 1000;
    row = judge_claim(claim, more, settings);
    BOOST_TEST(row.method == "exact");
    BOOST_TEST(row.p.value() == 2.0 / 924, tolerance(1e-12));

    // In three of ten generations the means are the other way round: not in every one, but in most.
    for (RunHistory &history : settings[0].histories)
        for (int generation = 0; generation < 3; ++generation) history.best[generation] = -1;
    row = judge_claim(claim, fake_analysis(), settings);
    BOOST_TEST(row.effect.value() == 0.7, tolerance(1e-12));
    BOOST_TEST(row.high.value() == 0.7, tolerance(1e-12));
    BOOST_TEST(row.verdict == "inconclusive");
    claim.level = 0.5;
    BOOST_TEST(judge_claim(claim, fake_analysis(), settings).verdict == "reproduced");
    std::swap(claim.a, claim.b);
    BOOST_TEST(judge_claim(claim, fake_analysis(), settings).verdict == "contradicted");
}

BOOST_AUTO_TEST_CASE(a_mean_ahead_by_chance_is_inconclusive) {
    // Always ahead, but by a tenth of what runs differ.
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    const std::vector<SettingRuns> close{fake_setting(a, {1.1, 2.1, 3.1, 4.1, 5.1, 6.1}),
                                         fake_setting(b, low)};
    Claim claim = fake_claim("mean_ahead");
    for (const double level : {0.5, 1.0}) {
        claim.level = level;
        const ClaimRow row = judge_claim(claim, fake_analysis(), close);
        BOOST_TEST(row.effect.value() == 1);
        BOOST_TEST(row.p.value() > 0.5);
        BOOST_TEST(row.verdict == "inconclusive");
    }
}

BOOST_AUTO_TEST_CASE(gaits_that_do_not_last_are_counted_against_the_originals) {
    const Spec a = fake_spec("ns", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, high)};
    Claim claim = fake_claim("cyclic");
    claim.b = "";
    claim.level = 0.05, claim.count = 1, claim.bound = 0.6;
    // Every other one glides.
    const auto stop = [&](int runs) {
        for (int run = 0; run < runs; ++run) {
            ChampionRow &champion = settings[0].histories[run].after.at(10).champion;
            (run % 2 ? champion.late_share : champion.late_actuation) = 0.01;
        }
        return judge_claim(claim, fake_analysis(), settings);
    };
    BOOST_TEST(stop(0).verdict == "reproduced");
    BOOST_TEST(stop(0).p_equivalence.value() == 0.4 * 0.4 * 0.4 * 0.4 * 0.4 * 0.4, tolerance(1e-12));
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
    std::vector<SettingRuns> settings{fake_setting(a, {9, 8, 7, 1, 1, 1}),
                                      fake_setting(b, {6, 6, 5, 4, 3, 2})};
    Claim claim = fake_claim("elongated");
    claim.count = 3;
    const auto lengthen = [&](int runs) {
        for (int run = 0; run < runs; ++run) settings[0].histories[run].after.at(10).champion.elongation = 6;
        return judge_claim(claim, fake_analysis(), settings);
    };
    const ClaimRow two = lengthen(2);
    BOOST_TEST(two.effect.value() == 2);
    BOOST_TEST(two.verdict == "inconclusive");
    // The only three of twelve that are a's and elongated are the best three: twice 1 of choose(12, 3).
    const ClaimRow three = lengthen(3);
    BOOST_TEST(three.effect.value() == 3);
    BOOST_TEST(three.p.value() == 2.0 / 220, tolerance(1e-12));
    BOOST_TEST(three.verdict == "reproduced");
}

BOOST_AUTO_TEST_CASE(settings_of_different_length_meet_at_the_shorter) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 7, 10);
    const std::vector<SettingRuns> settings{fake_setting(a, high), fake_setting(b, low)};
    const ClaimRow row = judge_claim(fake_claim("size_entropy", "greater"), fake_analysis(), settings);
    BOOST_TEST(row.at_generation == 7);
    BOOST_TEST(row.note == "data end after 7 of 10 generations");
}
