// SPDX-License-Identifier: MIT
#include "genome/weight.h"

#include "parameters/parameters.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_weight_is_the_nearest_multiple_of_the_step_of_two_the_higher) {
    BOOST_TEST(rounded_weight(0.3, 0.25) == 0.25);
    BOOST_TEST(rounded_weight(-0.3, 0.25) == -0.25);
    BOOST_TEST(rounded_weight(0.375, 0.25) == 0.5);
    BOOST_TEST(rounded_weight(-0.375, 0.25) == -0.25);
    BOOST_TEST(rounded_weight(-8, 0.25) == -8);
    BOOST_TEST(rounded_weight(0.1, 0) == 0.1);
}

BOOST_AUTO_TEST_CASE(the_standard_step_is_a_power_of_two_and_divides_the_limit) {
    const NeatParameters p;
    BOOST_TEST(p.weight_step == 0x1p-20);
    BOOST_TEST(rounded_weight(p.weight_limit, p.weight_step) == p.weight_limit);
    BOOST_TEST(rounded_weight(rounded_weight(0.123456789, p.weight_step), p.weight_step) ==
               rounded_weight(0.123456789, p.weight_step));
}
