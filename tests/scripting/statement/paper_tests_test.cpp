// SPDX-License-Identifier: MIT
// experiments/paper/tests.lua: the verdicts of the paper's tests on runs whose values are known.
#include "analysis/claims.h"
#include "core/analysis/fake_setting.h"
#include "statement/statistic_state.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <set>

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

/// A claim of the module paper.tests about setting "ns" against "neat": the call, and its options.
Claim claim_of(const std::string &test, const std::string &options, const std::string &b = "neat") {
    const std::string of_b = b.empty() ? "" : "b = '" + b + "', ";
    const auto sources =
        test::script("local tests = require 'paper.tests'\nreturn { statistics = { claims = {\ntests." +
                     test + " { id = 'S', statement = 's', a = 'ns', " + of_b + options + " } } } }");
    Claim claim{.id = "S", .test = test, .a = "ns", .b = b};
    claim.judge = judge_of({sources, ""}, 0);
    return claim;
}

ClaimRow judge(const Claim &claim, const std::vector<SettingRuns> &settings,
               const Analysis &analysis = fake_analysis()) {
    return judge_claim(claim, recorded_data(analysis, settings));
}

ClaimRow judge(const Claim &claim, const std::vector<double> &ns, const std::vector<double> &neat,
               const Analysis &analysis = fake_analysis()) {
    static const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    return judge(claim, {fake_setting(a, ns), fake_setting(b, neat)}, analysis);
}

const Claim greater = claim_of("best_at_generation", "expect = 'greater'");

} // namespace

BOOST_AUTO_TEST_CASE(a_clear_difference_is_reproduced_with_effect_interval_and_p) {
    const ClaimRow row = judge(greater, high, low);
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
    BOOST_TEST(judge(greater, low, high).verdict == "contradicted");
    BOOST_TEST(judge(greater, low, mixed).verdict == "inconclusive");
}

BOOST_AUTO_TEST_CASE(no_difference_is_not_reproduced_for_want_of_runs) {
    const Claim claim = claim_of("best_at_generation", "expect = 'no_difference', bound = 0.21");
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
    for (const char *test : {"best_at_generation", "size_entropy"})
        for (const char *options : {"expect = 'greater'", "expect = 'no_difference', bound = 0.4"}) {
            const ClaimRow row = judge(claim_of(test, options), {1000}, {1}, planned(1));
            BOOST_TEST(row.verdict == "inconclusive", test);
            BOOST_TEST(row.note.starts_with("of so few runs p"), test);
        }
    const ClaimRow ahead = judge(claim_of("mean_ahead", "level = 1"), {1000}, {1}, planned(1));
    BOOST_TEST(ahead.verdict == "inconclusive");
    BOOST_TEST(ahead.note.starts_with("of so few runs p"));
    BOOST_TEST(judge(greater, {7, 8, 9}, {1, 2, 3}, planned(3)).note == "of so few runs p is at least 0.1");
    for (const char *test : {"top_runs", "elongated"})
        for (const int count : {1, 2, 5}) {
            const Claim claim = claim_of(test, "count = " + std::to_string(count));
            BOOST_TEST(judge(claim, {1000}, {1}, planned(1)).verdict == "inconclusive");
            BOOST_TEST(judge(claim, {1}, {1000}, planned(1)).verdict == "inconclusive");
            BOOST_TEST(judge(claim, {1}, {1000}, planned(1)).note.starts_with("of so few runs p"));
        }
    const Claim claim = claim_of("cyclic", "level = 0.1, count = 0, bound = 0.25", "");
    BOOST_TEST(judge(claim, {1000}, {}, planned(1)).verdict == "inconclusive");
    BOOST_TEST(judge(claim, {1000}, {}, planned(1)).note ==
               "of so few runs p of equivalence is at least 0.75");
}

BOOST_AUTO_TEST_CASE(tied_values_of_few_runs_are_not_significant) {
    // The normal approximation gives 0.047.
    const ClaimRow row = judge(greater, {2, 2, 2}, {1, 1, 1}, planned(3));
    BOOST_TEST(row.p.value() == 0.1, tolerance(1e-12));
    BOOST_TEST(row.method == "exact");
    BOOST_TEST(row.verdict == "inconclusive");
}

BOOST_AUTO_TEST_CASE(an_interval_takes_runs) {
    Analysis analysis = fake_analysis();
    analysis.interval_runs = 7;
    for (const Claim &claim : {greater, claim_of("mean_ahead", "level = 1")}) {
        BOOST_TEST(judge(claim, high, low).low.has_value());
        BOOST_TEST(!judge(claim, high, low, analysis).low.has_value());
        BOOST_TEST(!judge(claim, high, low, analysis).high.has_value());
    }
}

BOOST_AUTO_TEST_CASE(runs_without_a_value_are_left_out_and_reported) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, high), fake_setting(b, low)};
    settings[0].histories[2].after.at(10).direction_resultant = std::nullopt;
    const ClaimRow row = judge(claim_of("direction", "expect = 'greater'"), settings);
    BOOST_TEST(row.note == "1 runs of ns have no such value");
    BOOST_TEST(row.p.value() == 2.0 / 462, tolerance(1e-12)); // five against six
    for (RunHistory &history : settings[1].histories) history.after.at(10).direction_resultant = std::nullopt;
    const ClaimRow none = judge(claim_of("direction", "expect = 'greater'"), settings);
    BOOST_TEST(none.verdict == "inconclusive");
    BOOST_TEST(!none.p.has_value());
}

BOOST_AUTO_TEST_CASE(every_rank_test_looks_at_its_own_measure) {
    for (const char *test : {"size_entropy", "fitness_spread", "direction", "side_switches"}) {
        BOOST_TEST(judge(claim_of(test, "expect = 'greater'"), high, low).verdict == "reproduced", test);
        BOOST_TEST(judge(claim_of(test, "expect = 'less'"), high, low).verdict == "contradicted", test);
    }
}

BOOST_AUTO_TEST_CASE(single_runs_can_be_compared) {
    const ClaimRow row = judge(greater, {2}, {1});
    BOOST_TEST(row.verdict == "open");
    BOOST_TEST(row.p.value() == 1);
}

BOOST_AUTO_TEST_CASE(the_best_runs_are_counted_across_both_settings) {
    Claim claim = claim_of("top_runs", "count = 3");
    ClaimRow row = judge(claim, {9, 8, 7, 1, 1, 1}, {6, 5, 4, 3, 2, 1});
    BOOST_TEST(row.effect.value() == 3);
    // Twice choose(6, 3) / choose(12, 3): the best three of six and six say nothing.
    BOOST_TEST(row.p.value() == 40.0 / 220, tolerance(1e-12));
    BOOST_TEST(row.verdict == "inconclusive");
    BOOST_TEST(row.note == "of so few runs p is at least 0.182");
    claim = claim_of("top_runs", "count = 5"); // choose(6, 5) / choose(12, 5)
    row = judge(claim, {9, 8, 7, 6, 5, 1}, {4, 4, 4, 3, 2, 1});
    BOOST_TEST(row.p.value() == 12.0 / 792, tolerance(1e-12));
    BOOST_TEST(row.verdict == "reproduced");
    row = judge(claim, {9, 8, 1, 1, 1, 1}, {8.5, 5, 4, 3, 2, 1});
    BOOST_TEST(row.effect.value() == 2);
    BOOST_TEST(row.verdict == "inconclusive");
    BOOST_TEST(judge(claim, {1, 1, 1, 1, 1, 1}, {8, 7, 6, 5, 4, 3}).verdict == "contradicted");
}

BOOST_AUTO_TEST_CASE(a_tie_among_the_best_speaks_against_the_claim) {
    Claim claim = claim_of("top_runs", "count = 1");
    BOOST_TEST(judge(claim, {9, 1, 1, 1, 1, 1}, {9, 1, 1, 1, 1, 1}).effect.value() == 0);
    // And for neither verdict: equal runs are inconclusive.
    claim = claim_of("top_runs", "count = 5");
    BOOST_TEST(judge(claim, std::vector<double>(6, 7), std::vector<double>(6, 7)).verdict == "inconclusive");
}

BOOST_AUTO_TEST_CASE(a_mean_is_ahead_by_a_test_over_runs) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, high), fake_setting(b, low)};
    Claim claim = claim_of("mean_ahead", "level = 1");
    ClaimRow row = judge(claim, settings);
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.effect.value() == 1);
    BOOST_TEST(!row.p_equivalence.has_value());
    // 924 ways to share out twelve runs are more than 500 draws.
    BOOST_TEST(row.method == "drawn");
    Analysis more = fake_analysis();
    more.resamples = 1000;
    row = judge(claim, settings, more);
    BOOST_TEST(row.method == "exact");
    BOOST_TEST(row.p.value() == 2.0 / 924, tolerance(1e-12));

    // In three of ten generations the means are the other way round: not in every one, but in most.
    for (RunHistory &history : settings[0].histories)
        for (int generation = 0; generation < 3; ++generation)
            history.generations[generation].best_fitness = -1;
    row = judge(claim, settings);
    BOOST_TEST(row.effect.value() == 0.7, tolerance(1e-12));
    BOOST_TEST(row.high.value() == 0.7, tolerance(1e-12));
    BOOST_TEST(row.verdict == "inconclusive");
    claim = claim_of("mean_ahead", "level = 0.5");
    BOOST_TEST(judge(claim, settings).verdict == "reproduced");
    std::swap(claim.a, claim.b);
    BOOST_TEST(judge(claim, settings).verdict == "contradicted");
}

BOOST_AUTO_TEST_CASE(a_mean_ahead_by_chance_is_inconclusive) {
    // Always ahead, but by a tenth of what runs differ.
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    const std::vector<SettingRuns> close{fake_setting(a, {1.1, 2.1, 3.1, 4.1, 5.1, 6.1}),
                                         fake_setting(b, low)};
    for (const char *level : {"0.5", "1"}) {
        const Claim claim = claim_of("mean_ahead", "level = " + std::string(level));
        const ClaimRow row = judge(claim, close);
        BOOST_TEST(row.effect.value() == 1);
        BOOST_TEST(row.p.value() > 0.5);
        BOOST_TEST(row.verdict == "inconclusive");
    }
}

BOOST_AUTO_TEST_CASE(gaits_that_do_not_last_are_counted_against_the_originals) {
    const Spec a = fake_spec("ns", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, high)};
    const Claim claim = claim_of("cyclic", "level = 0.05, count = 1, bound = 0.6", "");
    // Every other one glides.
    const auto stop = [&](int runs) {
        for (int run = 0; run < runs; ++run) {
            ChampionRow &champion = settings[0].histories[run].after.at(10).champion;
            (run % 2 ? champion.late_share : champion.late_actuation) = 0.01;
        }
        return judge(claim, settings);
    };
    BOOST_TEST(stop(0).verdict == "reproduced");
    BOOST_TEST(stop(0).p_equivalence.value() == 0.4 * 0.4 * 0.4 * 0.4 * 0.4 * 0.4, tolerance(1e-12));
    BOOST_TEST(stop(1).verdict == "reproduced");
    const ClaimRow some = stop(2);
    BOOST_TEST(some.effect.value() == 2);
    BOOST_TEST(some.verdict == "inconclusive");
    const ClaimRow all = stop(6);
    // Six of six beside one of the original's twenty: choose(7, 6) ways of choose(26, 6).
    BOOST_TEST(all.p.value() == 7.0 / 230230, tolerance(1e-12));
    BOOST_TEST(all.verdict == "contradicted");
    BOOST_TEST(all.setting_b == "");
    BOOST_TEST(all.runs_b == 0);
}

BOOST_AUTO_TEST_CASE(the_best_must_be_as_and_more_elongated_than_the_rest) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 10, 10);
    std::vector<SettingRuns> settings{fake_setting(a, {9, 8, 7, 1, 1, 1}),
                                      fake_setting(b, {6, 6, 5, 4, 3, 2})};
    const Claim claim = claim_of("elongated", "count = 3");
    const auto lengthen = [&](int runs) {
        for (int run = 0; run < runs; ++run) settings[0].histories[run].after.at(10).champion.elongation = 6;
        return judge(claim, settings);
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

BOOST_AUTO_TEST_CASE(a_wrong_option_is_an_error_at_the_claims_line) {
    const auto refusal = [](const std::string &test, const std::string &options) {
        const Analysis analysis = fake_analysis();
        return test::refusal([&] {
            const auto sources =
                test::script("local tests = require 'paper.tests'\nreturn { statistics = { claims = "
                             "{\ntests." +
                             test + " { id = 'S', a = 'ns', b = 'neat', " + options + " } } } }");
            StatisticState({sources, ""}, analysis, Allowance::trial);
        });
    };
    BOOST_TEST(refusal("best_at_generation", "expect = 'greater'") == "");
    BOOST_TEST(refusal("best_at_generation", "expect = 'bigger'") ==
               "test.lua:3: claim 'S': expect must be 'greater', 'less' or 'no_difference', not bigger");
    for (const char *bound : {"", "bound = 0", "bound = 0.5", "bound = -0.1", "bound = '0.2'"})
        BOOST_TEST(test::contains(refusal("size_entropy", "expect = 'no_difference', " + std::string(bound)),
                                  "test.lua:3: claim 'S': no_difference needs a bound above 0 and below 0.5"),
                   bound);
    BOOST_TEST(test::contains(refusal("direction", "expect = 'less', bound = 0.2"),
                              "only no_difference has a bound"));
    for (const char *options : {"", "level = 0", "level = 1.5"})
        BOOST_TEST(
            test::contains(refusal("mean_ahead", options), "test.lua:3: claim 'S': level must be above 0"));
    for (const char *options : {"", "count = 0", "count = 1.5", "count = 0 / 0", "count = math.huge"})
        for (const char *test : {"top_runs", "elongated"})
            BOOST_TEST(test::contains(refusal(test, options),
                                      "test.lua:3: claim 'S': count must be a whole number"));
    BOOST_TEST(
        test::contains(refusal("cyclic", "level = 0.1, count = 0"), "test.lua:3: claim 'S': bound must be"));
    BOOST_TEST(test::contains(refusal("best_at_generations", ""), "test.lua:3: "));
}

BOOST_AUTO_TEST_CASE(the_best_runs_need_all_and_fall_with_fewer_than_half) {
    // Of ten and ten runs, as many as are stated of the best five are ns's: p is below 0.05 for five and for none.
    const Claim claim = claim_of("top_runs", "count = 5");
    const auto verdict = [&](int of_ns) {
        std::vector<double> ns = values(1, 10), neat = values(1.5, 10);
        for (int i = 0; i < 5; ++i) (i < of_ns ? ns : neat)[5 + i] = 100 + i;
        return judge(claim, ns, neat, planned(10)).verdict;
    };
    BOOST_TEST(verdict(5) == "reproduced");
    for (const int some : {1, 2, 3, 4}) BOOST_TEST(verdict(some) == "inconclusive", some);
    BOOST_TEST(verdict(0) == "contradicted");
}

BOOST_AUTO_TEST_CASE(a_difference_within_the_bound_is_none_even_if_it_is_significant) {
    // Fifty runs each, a bound near 1/2: A12 = 0.69 is significant and within it.
    const Claim claim = claim_of("best_at_generation", "expect = 'no_difference', bound = 0.45");
    const ClaimRow row = judge(claim, values(13, 49), values(1, 49), planned(49));
    BOOST_TEST(row.p.value() < 0.05);
    BOOST_TEST(row.p_equivalence.value() < 0.05);
    BOOST_TEST(row.verdict == "reproduced");
}
