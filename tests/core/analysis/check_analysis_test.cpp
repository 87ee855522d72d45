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
    analysis.claims = {fake_claim()};
    spoil(analysis);
    return message_of<InputError>([&] { check_analysis(analysis, settings); });
}

} // namespace

BOOST_AUTO_TEST_CASE(a_sound_analysis_passes) {
    BOOST_TEST(refusal([](Analysis &) {}) == "");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].b = ""; }) == "");
    BOOST_TEST(refusal([](Analysis &a) { a.tables = {{"speeds", nullptr}}; }) == "");
}

BOOST_AUTO_TEST_CASE(a_table_has_a_name_of_its_own) {
    BOOST_TEST(refusal([](Analysis &a) {
                   a.tables = {{"runs", nullptr}};
               }) == "planula writes runs.csv itself; give the table 'runs' another name");
    BOOST_TEST(refusal([](Analysis &a) {
                   a.tables = {{"manifest", nullptr}};
               }) == "planula writes manifest.csv itself; give the table 'manifest' another name");
    for (const char *name : {"", "../speeds", "a/b", "two words"})
        BOOST_TEST(refusal([&](Analysis &a) {
                       a.tables = {{name, nullptr}};
                   }) == "the name of a table is 1 to 100 letters, digits, '-' and '_', not '" +
                             std::string(name) + "'");
}

BOOST_AUTO_TEST_CASE(an_error_about_an_unknown_name_suggests_the_nearest) {
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].a = "nt"; }) ==
               "claim 'S': there is no setting 'nt'; did you mean 'ns'?");
    BOOST_TEST(refusal([](Analysis &a) { a.claims[0].b = "neet"; }) ==
               "claim 'S': there is no setting 'neet'; did you mean 'neat'?");
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
}
