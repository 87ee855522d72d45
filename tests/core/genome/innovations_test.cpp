// SPDX-License-Identifier: MIT
#include "genome/innovations.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_link_keeps_its_number_and_direction_matters) {
    Innovations innovations(5);
    BOOST_TEST(innovations.link(0, 3) == 0);
    BOOST_TEST(innovations.link(3, 0) == 1);
    BOOST_TEST(innovations.link(1, 3) == 2);
    BOOST_TEST(innovations.link(0, 3) == 0);
    BOOST_TEST(innovations.links() == 3);
}

BOOST_AUTO_TEST_CASE(splits_of_a_link_are_remembered_in_order) {
    Innovations innovations(5);
    BOOST_TEST(innovations.splits(0, 3).empty());
    BOOST_TEST(innovations.new_split(0, 3) == 5);
    BOOST_TEST(innovations.new_split(1, 3) == 6);
    BOOST_TEST(innovations.new_split(0, 3) == 7);
    const std::vector<int> expected{5, 7};
    const auto splits = innovations.splits(0, 3);
    BOOST_TEST(std::equal(splits.begin(), splits.end(), expected.begin(), expected.end()));
    BOOST_TEST(innovations.splits(3, 0).empty());
    BOOST_TEST(innovations.next_node() == 8);
}
