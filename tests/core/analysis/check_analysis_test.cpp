// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"
#include "base/error.h"
#include "base/text.h"
#include "core/analysis/fake_setting.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

const std::vector<Spec> settings{fake_spec("ns", 10, 10), fake_spec("neat", 10, 10)};

std::string refusal(const std::function<void(Analysis &)> &spoil) {
    Analysis analysis = fake_analysis();
    analysis.claims = {fake_claim("best_at_generation", "greater")};
    spoil(analysis);
    return message_of<InputError>([&] { check_analysis(analysis, settings); });
}

} // namespace

BOOST_AUTO_TEST_CASE(a_sound_analysis_passes) {
    BOOST_TEST(refusal([](Analysis &) {}) == "");
    for (const auto test : claim_tests()) {
        BOOST_TEST(refusal([&](Analysis &a) {
                       a.claims = {fake_claim(std::string(test), "greater")};
                       a.claims[0].level = 0.5, a.claims[0].count = 3;
                       a.claims[0].bound = test == "cyclic" ? 0.25 : 0;
                   }) == "",
                   test);
    }
}

BOOST_AUTO_TEST_CASE(an_error_about_an_unknown_name_suggests_the_nearest) {
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].test = "best_at_generations"; }) ==
               "claim 'S': there is no test 'best_at_generations'; did you mean 'best_at_generation'?");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].a = "nt"; }) ==
               "claim 'S': there is no setting 'nt'; did you mean 'ns'?");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].b = "neet"; }) ==
               "claim 'S': there is no setting 'neet'; did you mean 'neat'?");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].expect = "greatest"; }) ==
               "claim 'S': expect must be greater, less or no_difference, and is 'greatest'; did you mean "
               "'greater'?");
    BOOST_TEST(refusal([](Analysis &a) { a.endpoint_settings = {"neatt"}; }) ==
               "endpoints: there is no setting 'neatt'; did you mean 'neat'?");
}

BOOST_AUTO_TEST_CASE(numbers_out_of_range_are_refused_with_rule_and_value) {
    BOOST_TEST(refusal([](Analysis &a) { a.sample_share = 0; }) ==
               "statistics: sample_share = 0 must be above 0 and at most 1");
    BOOST_TEST(refusal([](Analysis &a) { a.significance = std::nan(""); }) ==
               "statistics: significance = nan must be above 0 and at most 1");
    BOOST_TEST(refusal([](Analysis &a) { a.confidence = 1; }) ==
               "statistics: confidence = 1 must be below 1");
    BOOST_TEST(refusal([](Analysis &a) { a.resamples = 0; }) ==
               "statistics: resamples = 0 must be at least 1");
    BOOST_TEST(refusal([](Analysis &a) { a.sample_least = -1; }) ==
               "statistics: sample_least = -1 must be at least 0");
    BOOST_TEST(refusal([](Analysis &a) { a.interval_runs = 0; }) ==
               "statistics: interval_runs = 0 must be at least 1");
    BOOST_TEST(refusal([](Analysis &a) { a.direction_distance = -1; }) ==
               "statistics: direction_distance = -1 must be finite and at least 0");
    for (const int classes : {-1, 0, 3, 30, 101, 200, 2147483647})
        BOOST_TEST(refusal([&](Analysis &a) { a.fitness_classes = classes; }) ==
                   "statistics: fitness_classes = " + std::to_string(classes) +
                       " must divide 100: 1, 2, 4, 5, 10, 20, 25, 50 or 100");
    for (const int classes : {1, 2, 4, 5, 10, 20, 25, 50, 100})
        BOOST_TEST(refusal([&](Analysis &a) { a.fitness_classes = classes; }) == "");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].generation = -1; }) ==
               "claim 'S': generation = -1 must be at least 0");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].test = "top_runs"; }) ==
               "claim 'S': count = 0 must be at least 1");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].test = "mean_ahead"; }) ==
               "claim 'S': level = 0 must be above 0 and at most 1");
}

BOOST_AUTO_TEST_CASE(a_claim_of_no_difference_states_its_bound) {
    for (const double bound : {0.0, 0.5, -0.1})
        BOOST_TEST(refusal([&](Analysis &a) {
                       a.claims[0].expect = "no_difference", a.claims[0].bound = bound;
                   }) == "claim 'S': bound = " + to_text(bound) +
                             " must be above 0 and below 0.5, how far A12 may be from 1/2");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].expect = "no_difference", a.claims[0].bound = 0.21; }) ==
               "");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].bound = 0.21; }) ==
               "claim 'S': bound = 0.21 is of no use: only no_difference and cyclic have one");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].test = "cyclic", a.claims[0].level = 0.1; }) ==
               "claim 'S': bound = 0 must be above 0 and below 1, the share of runs without a lasting gait");
}
