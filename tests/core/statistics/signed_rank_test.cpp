// SPDX-License-Identifier: MIT
#include "statistics/signed_rank.h"

#include "base/error.h"
#include "core/statistics/reference.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <map>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(every_p_is_that_of_r) {
    const std::map<std::string, RankMethod> methods{
        {"automatic", RankMethod::automatic},
        {"exact", RankMethod::exact},
        {"normal", RankMethod::normal},
        {"normal_without_continuity", RankMethod::normal_without_continuity}};
    for (const Reference &r : references_of("signed_rank")) {
        const SignedRank found = signed_rank(r.a, r.b, methods.at(r.kind));
        BOOST_TEST_CONTEXT(r.kind << " of " << r.a.size() << " pairs") {
            BOOST_TEST(found.statistic == r.expected[0]);
            BOOST_TEST(found.p == r.expected[1], tt::tolerance(1e-11));
            BOOST_TEST(found.greater == r.expected[2], tt::tolerance(1e-11));
            BOOST_TEST(found.less == r.expected[3], tt::tolerance(1e-11));
        }
    }
}

BOOST_AUTO_TEST_CASE(few_pairs_are_tested_exactly_and_cannot_be_significant) {
    const std::vector<double> a{3, 4, 5, 6, 7}, b{1, 1, 1, 1, 1};
    for (std::size_t n = 1; n <= a.size(); ++n) {
        const SignedRank found = signed_rank(std::span(a).first(n), std::span(b).first(n));
        BOOST_TEST(found.exact);
        BOOST_TEST(found.p == std::min(1.0, std::ldexp(2, -static_cast<int>(n))));
        BOOST_TEST(found.p == found.least);
        BOOST_TEST(found.greater == std::ldexp(1, -static_cast<int>(n)));
    }
}

BOOST_AUTO_TEST_CASE(pairs_without_a_difference_are_dropped) {
    const std::vector<double> a{5, 2, 9, 4, 4}, b{1, 2, 3, 5, 4}, rest_a{5, 9, 4}, rest_b{1, 3, 5};
    const SignedRank all = signed_rank(a, b), rest = signed_rank(rest_a, rest_b);
    BOOST_TEST(all.differences == 3u);
    BOOST_TEST(all.statistic == rest.statistic);
    BOOST_TEST(all.p == rest.p);
    const SignedRank none = signed_rank(b, b);
    BOOST_TEST(none.differences == 0u);
    BOOST_TEST(none.p == 1);
    BOOST_TEST(none.least == 1);
}

BOOST_AUTO_TEST_CASE(turning_the_pairs_round_turns_the_sides) {
    for (const Reference &r : references_of("signed_rank")) {
        const SignedRank one = signed_rank(r.a, r.b), other = signed_rank(r.b, r.a);
        BOOST_TEST(one.p == other.p, tt::tolerance(1e-11));
        BOOST_TEST(one.greater == other.less, tt::tolerance(1e-11));
    }
}

BOOST_AUTO_TEST_CASE(invalid_pairs_are_an_input_error_that_says_the_rule) {
    const std::vector<double> two{1, 2}, three{1, 2, 3}, bad{1, std::numeric_limits<double>::quiet_NaN()},
        none;
    BOOST_CHECK_EXCEPTION(signed_rank(two, three), InputError, [](const InputError &error) {
        return std::string(error.what()) ==
               "pairs need two samples of the same size: these have 2 and 3 values";
    });
    BOOST_CHECK_EXCEPTION(signed_rank(two, bad), InputError, [](const InputError &error) {
        return std::string(error.what()) == "the values of a sample are finite numbers: value 2 of 2 is nan";
    });
    BOOST_CHECK_THROW(signed_rank(none, none), InputError);
    std::vector<double> many;
    for (int i = 1; i <= 101; ++i) many.push_back(i);
    BOOST_CHECK_THROW(signed_rank(many, std::vector<double>(101), RankMethod::exact), InputError);
}
