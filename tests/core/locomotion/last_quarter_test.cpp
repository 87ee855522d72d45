// SPDX-License-Identifier: MIT
#include "locomotion/last_quarter.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(the_last_quarter_begins_at_a_multiple_of_the_interval) {
    BOOST_TEST(last_quarter(4000, 100) == 3000);
    BOOST_TEST(last_quarter(4000, 7) == 2996);
    BOOST_TEST(last_quarter(10, 1) == 7);
    BOOST_TEST(last_quarter(3, 10) == 0);
    BOOST_TEST(last_quarter(10000000, 1) == 7500000);
}
