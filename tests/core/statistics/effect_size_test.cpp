// SPDX-License-Identifier: MIT
#include "statistics/effect_size.h"

#include "base/error.h"
#include "core/statistics/reference.h"
#include "statistics/rank_sum.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(a12_counts_wins_and_half_the_ties) {
    const std::vector<double> a{1, 3, 5}, b{2, 3};
    BOOST_TEST(a12(a, b) == 3.5 / 6); // 3 > 2, 3 = 3, 5 > 2, 5 > 3
    BOOST_TEST(a12(b, a) == 2.5 / 6);
    BOOST_TEST(a12(std::vector<double>{9, 8}, std::vector<double>{1, 2, 3}) == 1);
    BOOST_TEST(a12(std::vector<double>{1, 2, 3}, std::vector<double>{9, 8}) == 0);
    BOOST_TEST(a12(std::vector<double>{4}, std::vector<double>{4, 4}) == 0.5);
}

BOOST_AUTO_TEST_CASE(a12_is_the_share_of_the_rank_sum_statistic) {
    const std::vector<double> a{1, 2, 2, 3, 5, 5, 5, 8}, b{2, 4, 5, 6, 7, 9, 9};
    BOOST_TEST(a12(a, b) == rank_sum(a, b).statistic / (8 * 7));
}

BOOST_AUTO_TEST_CASE(an_empty_sample_is_refused) {
    BOOST_CHECK_THROW(a12(std::vector<double>{}, std::vector<double>{1}), InputError);
    BOOST_CHECK_THROW(a12(std::vector<double>{1}, std::vector<double>{}), InputError);
}

BOOST_AUTO_TEST_CASE(cliff_delta_is_that_of_r) {
    for (const Reference &r : references_of("cliff_delta"))
        BOOST_TEST(cliff_delta(r.a, r.b) == r.expected[0], boost::test_tools::tolerance(1e-12));
}
