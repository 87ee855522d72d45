// SPDX-License-Identifier: MIT
#include "analysis/claims.h"

#include "core/analysis/fake_setting.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using boost::test_tools::tolerance;

namespace {

const std::vector<double> low{1, 2, 3, 4, 5, 6}, high{11, 12, 13, 14, 15, 16};

/// The row of a claim about two settings with these values, and a third one without runs.
ClaimRow judge(const Claim &claim, const std::vector<double> &ns, const std::vector<double> &neat,
               const Analysis &analysis = fake_analysis(), int generations = 10, int population = 10) {
    const Spec a = fake_spec("ns", generations, population), b = fake_spec("neat", generations, population),
               c = fake_spec("other", generations, population);
    const std::vector<SettingRuns> settings{fake_setting(a, ns), fake_setting(b, neat), fake_setting(c, {})};
    return judge_claim(claim, recorded_data(analysis, settings));
}

} // namespace

BOOST_AUTO_TEST_CASE(a_row_has_what_the_function_says) {
    const ClaimRow row = judge(fake_claim(), high, low);
    BOOST_TEST(row.id == "S");
    BOOST_TEST(row.test == "first");
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.effect_name == "difference");
    BOOST_TEST(row.effect.value() == 10);
    BOOST_TEST(row.p.value() == 0.1);
    BOOST_TEST(row.method == "exact");
    BOOST_TEST(!row.p_equivalence.has_value());
    BOOST_TEST(row.generation == 10);
    BOOST_TEST(row.at_generation == 10);
    BOOST_TEST(row.runs_a == 6);
    BOOST_TEST(row.runs_b == 6);
    BOOST_TEST(row.note == "of the first");
    BOOST_TEST(row.note_reached == row.note);
    BOOST_TEST(row.verdict_reached == row.verdict);
    BOOST_TEST(judge(fake_claim(), low, high).verdict == "contradicted");
}

BOOST_AUTO_TEST_CASE(a_claim_about_one_setting_has_no_second) {
    Claim claim = fake_claim();
    claim.b = "";
    const ClaimRow row = judge(claim, high, low);
    BOOST_TEST(row.setting_b == "");
    BOOST_TEST(row.runs_b == 0);
    BOOST_TEST(row.verdict == "reproduced");
}

BOOST_AUTO_TEST_CASE(a_calibrated_claim_is_judged_and_marked) {
    Claim claim = fake_claim();
    BOOST_TEST(judge(claim, high, low).calibrated == 0);
    claim.calibrated = true;
    BOOST_TEST(judge(claim, high, low).calibrated == 1);
    BOOST_TEST(judge(claim, high, low).verdict == "reproduced");
}

BOOST_AUTO_TEST_CASE(p_values_are_corrected_over_all_claims_and_say_which_decides) {
    Analysis analysis = fake_analysis();
    std::vector<ClaimRow> rows{
        {.id = "1", .p = 0.01, .verdict_reached = "reproduced"},
        {.id = "2", .p = 0.9, .p_equivalence = 0.04, .verdict_reached = "reproduced"},
        {.id = "3", .verdict_reached = "inconclusive"},
        {.id = "4", .p = 0.04, .p_equivalence = 0.9, .verdict_reached = "contradicted"},
        {.id = "5", .p = 0.001, .verdict = "open", .verdict_reached = "reproduced"}};
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
    BOOST_TEST(rows[4].decided_by == "p_holm"); // open, but decided at the generation that is reached
    rows[0].p = 0.001;
    correct_claims(rows, analysis.significance);
    BOOST_TEST(rows[0].decided_by == "p_holm");
}

BOOST_AUTO_TEST_CASE(data_that_end_early_leave_a_claim_open_with_its_value) {
    Analysis analysis = fake_analysis();
    analysis.design.design.generations = 2000;
    analysis.design.design.seeds = 20;
    analysis.design.neat.population = 300;
    const ClaimRow row = judge(fake_claim(), high, low, analysis);
    BOOST_TEST(row.verdict == "open");
    BOOST_TEST(row.verdict_reached == "reproduced");
    BOOST_TEST(row.note_reached == "of the first");
    BOOST_TEST(row.effect.value() == 10);
    BOOST_TEST(row.generation == 2000);
    BOOST_TEST(row.at_generation == 10);
    BOOST_TEST(row.note ==
               "data end after 10 of 2000 generations; 6 of 20 runs of ns; population 10 of 300 in ns; "
               "6 of 20 runs of neat; population 10 of 300 in neat");
}

BOOST_AUTO_TEST_CASE(a_claim_about_an_early_generation_is_decided_by_early_data) {
    Analysis analysis = fake_analysis();
    analysis.design.design.generations = 2000;
    Claim claim = fake_claim();
    claim.generation = 8;
    const ClaimRow row = judge(claim, high, low, analysis);
    BOOST_TEST(row.verdict == "reproduced");
    BOOST_TEST(row.at_generation == 8);
}

BOOST_AUTO_TEST_CASE(a_setting_without_runs_leaves_a_claim_open_without_value) {
    const ClaimRow row = judge(fake_claim(), high, {});
    BOOST_TEST(row.verdict == "open");
    BOOST_TEST(row.verdict_reached == "");
    BOOST_TEST(!row.effect.has_value());
    BOOST_TEST(!row.p.has_value());
    BOOST_TEST(row.at_generation == 0);
    BOOST_TEST(row.runs_a == 6);
    BOOST_TEST(row.runs_b == 0);
    BOOST_TEST(row.note == "no runs of neat");
    Analysis wider = fake_analysis();
    wider.design.neat.population = 300;
    BOOST_TEST(judge(fake_claim(), high, {}, wider).note == "population 10 of 300 in ns; no runs of neat");
}

BOOST_AUTO_TEST_CASE(what_a_function_asks_for_beyond_its_settings_counts) {
    // Of another setting: its runs must be complete, too.
    const auto asks = [](const std::string &name, int generations, bool missing) {
        return fake_claim([=](const ClaimCase &of, Asked &asked) {
            for (const SettingRuns &setting : of.data.settings)
                if (setting.spec->name == name) asked.settings.push_back(&setting);
            asked.generations = generations, asked.missing = missing;
            return compare_first(of, asked);
        });
    };
    BOOST_TEST(judge(asks("neat", 10, false), high, low).verdict == "reproduced");
    const ClaimRow absent = judge(asks("other", 0, true), high, low);
    BOOST_TEST(absent.verdict == "open");
    BOOST_TEST(absent.note == "no runs of other");
    BOOST_TEST(!absent.effect.has_value());

    // Of a later generation.
    const ClaimRow late = judge(asks("ns", 50, true), high, low);
    BOOST_TEST(late.verdict == "open");
    BOOST_TEST(late.note == "data end after 10 of 50 generations");
    BOOST_TEST(!late.effect.has_value());
    BOOST_TEST(!late.p.has_value());
}

BOOST_AUTO_TEST_CASE(settings_of_different_length_meet_at_the_shorter) {
    const Spec a = fake_spec("ns", 10, 10), b = fake_spec("neat", 7, 10);
    const Analysis analysis = fake_analysis();
    const std::vector<SettingRuns> settings{fake_setting(a, high), fake_setting(b, low)};
    const ClaimRow row = judge_claim(fake_claim(), recorded_data(analysis, settings));
    BOOST_TEST(row.at_generation == 7);
    BOOST_TEST(row.note == "data end after 7 of 10 generations");
}
