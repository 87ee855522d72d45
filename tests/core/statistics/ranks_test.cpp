// SPDX-License-Identifier: MIT
#include "statistics/ranks.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(equal_values_share_their_mean_rank) {
    const Ranks found = ranks(std::vector<double>{5, -1, 5, 7, 5, -1});
    BOOST_TEST((found.of == std::vector<double>{4, 1.5, 4, 6, 4, 1.5}));
    BOOST_TEST(found.tie_cubes == (27 - 3) + (8 - 2));
}

BOOST_AUTO_TEST_CASE(ranks_of_different_values_count_from_one) {
    const Ranks found = ranks(std::vector<double>{0.3, 0.1, 0.2});
    BOOST_TEST((found.of == std::vector<double>{3, 1, 2}));
    BOOST_TEST(found.tie_cubes == 0);
}

BOOST_AUTO_TEST_CASE(an_empty_sample_has_no_ranks) {
    BOOST_CHECK_THROW(ranks(std::vector<double>{}), InputError);
}
