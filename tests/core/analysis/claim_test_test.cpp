// SPDX-License-Identifier: MIT
#include "analysis/claim_test.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::string verdict(const char *expect, double p, double effect, double low, double high) {
    return rank_verdict(expect, p, effect, low, high, 0.05);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_difference_needs_significance_and_the_right_side) {
    BOOST_TEST(verdict("greater", 0.01, 0.8, 0.6, 0.9) == "reproduced");
    BOOST_TEST(verdict("greater", 0.01, 0.2, 0.1, 0.4) == "contradicted");
    BOOST_TEST(verdict("greater", 0.20, 0.8, 0.4, 0.9) == "inconclusive");
    BOOST_TEST(verdict("greater", 0.05, 0.8, 0.6, 0.9) == "inconclusive");
    BOOST_TEST(verdict("less", 0.01, 0.2, 0.1, 0.4) == "reproduced");
    BOOST_TEST(verdict("less", 0.01, 0.8, 0.6, 0.9) == "contradicted");
    BOOST_TEST(verdict("less", 0.20, 0.2, 0.1, 0.6) == "inconclusive");
}

BOOST_AUTO_TEST_CASE(no_difference_needs_test_and_interval_to_agree) {
    BOOST_TEST(verdict("no_difference", 0.30, 0.6, 0.4, 0.8) == "reproduced");
    BOOST_TEST(verdict("no_difference", 0.01, 0.8, 0.6, 0.9) == "contradicted");
    BOOST_TEST(verdict("no_difference", 0.06, 0.7, 0.51, 0.9) == "inconclusive");
    BOOST_TEST(verdict("no_difference", 0.04, 0.7, 0.49, 0.9) == "inconclusive");
}

BOOST_AUTO_TEST_CASE(top_runs_need_all_and_fall_with_fewer_than_half) {
    BOOST_TEST(top_verdict(5, 5) == "reproduced");
    BOOST_TEST(top_verdict(4, 5) == "inconclusive");
    BOOST_TEST(top_verdict(3, 5) == "inconclusive");
    BOOST_TEST(top_verdict(2, 5) == "contradicted");
    BOOST_TEST(top_verdict(1, 2) == "inconclusive");
    BOOST_TEST(top_verdict(0, 2) == "contradicted");
}

BOOST_AUTO_TEST_CASE(every_test_is_found_by_its_name) {
    BOOST_TEST(claim_tests().size() == 9u);
    for (const auto name : claim_tests()) BOOST_TEST(find_test(name)->name == name);
    BOOST_TEST(find_test("best_at_generatio") == nullptr);
    BOOST_TEST(!find_test("cyclic")->compares_two());
}
