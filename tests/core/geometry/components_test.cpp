// SPDX-License-Identifier: MIT
#include "geometry/components.h"

#include <boost/test/unit_test.hpp>

BOOST_AUTO_TEST_CASE(joining_tells_whether_two_components_became_one) {
    planula::Components components(5);
    BOOST_TEST(components.join(0, 1));
    BOOST_TEST(components.join(2, 3));
    BOOST_TEST(!components.connected(1, 2));
    BOOST_TEST(components.join(1, 2));
    BOOST_TEST(!components.join(0, 3));
    BOOST_TEST(components.connected(0, 3));
    BOOST_TEST(!components.connected(0, 4));
}
