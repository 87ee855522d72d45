// SPDX-License-Identifier: MIT
#include "analysis/claim_test.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::string verdict(const char *expect, double p, double effect) {
    return rank_verdict(expect, {.effect = effect, .p = p}, 0.05);
}

std::string verdict_of_none(double p, double p_equivalence) {
    return rank_verdict("no_difference", {.effect = 0.6, .p = p, .p_equivalence = p_equivalence}, 0.05);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_difference_needs_significance_and_the_right_side) {
    BOOST_TEST(verdict("greater", 0.01, 0.8) == "reproduced");
    BOOST_TEST(verdict("greater", 0.01, 0.2) == "contradicted");
    BOOST_TEST(verdict("greater", 0.20, 0.8) == "inconclusive");
    BOOST_TEST(verdict("greater", 0.05, 0.8) == "inconclusive");
    BOOST_TEST(verdict("less", 0.01, 0.2) == "reproduced");
    BOOST_TEST(verdict("less", 0.01, 0.8) == "contradicted");
    BOOST_TEST(verdict("less", 0.20, 0.2) == "inconclusive");
}

BOOST_AUTO_TEST_CASE(no_difference_needs_equivalence_and_not_a_lack_of_significance) {
    BOOST_TEST(verdict_of_none(0.90, 0.01) == "reproduced");
    BOOST_TEST(verdict_of_none(0.90, 0.20) == "inconclusive");
    BOOST_TEST(verdict_of_none(0.90, 0.05) == "inconclusive");
    BOOST_TEST(verdict_of_none(0.01, 0.90) == "contradicted");
    // Different, but by less than the bound.
    BOOST_TEST(verdict_of_none(0.01, 0.01) == "reproduced");
}

BOOST_AUTO_TEST_CASE(top_runs_need_all_and_fall_with_fewer_than_half) {
    BOOST_TEST(top_verdict(5, 5, 5, 0.01, 0.05) == "reproduced");
    BOOST_TEST(top_verdict(5, 5, 5, 0.05, 0.05) == "inconclusive");
    BOOST_TEST(top_verdict(4, 4, 5, 0.01, 0.05) == "inconclusive");
    BOOST_TEST(top_verdict(3, 3, 5, 0.01, 0.05) == "inconclusive");
    BOOST_TEST(top_verdict(2, 2, 5, 0.01, 0.05) == "contradicted");
    BOOST_TEST(top_verdict(2, 2, 5, 0.20, 0.05) == "inconclusive");
    BOOST_TEST(top_verdict(0, 3, 5, 0.01, 0.05) == "inconclusive");
    BOOST_TEST(top_verdict(1, 1, 2, 0.01, 0.05) == "inconclusive");
    BOOST_TEST(top_verdict(0, 0, 2, 0.01, 0.05) == "contradicted");
}

BOOST_AUTO_TEST_CASE(every_test_is_found_by_its_name) {
    BOOST_TEST(claim_tests().size() == 9u);
    for (const auto name : claim_tests()) BOOST_TEST(find_test(name)->name == name);
    BOOST_TEST(find_test("best_at_generatio") == nullptr);
    BOOST_TEST(!find_test("cyclic")->compares_two());
}
