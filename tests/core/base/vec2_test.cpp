// SPDX-License-Identifier: MIT
#include "base/vec2.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_quarter_turn_of_the_arguments_turns_the_results_to_the_bit) {
    const auto turn = [](Vec2f v) { return Vec2f{-v.y, v.x}; };
    const Vec2f a{0.1f, -2.7f}, b{1.3f, 0.7f};
    BOOST_TEST(dot(turn(a), turn(b)) == dot(a, b));
    BOOST_TEST(cross(turn(a), turn(b)) == cross(a, b));
    BOOST_TEST((right_normal(turn(a)) == turn(right_normal(a))));
    BOOST_TEST((turn(a) + turn(b) == turn(a + b)));
}

BOOST_AUTO_TEST_CASE(the_right_normal_of_east_is_south) {
    BOOST_TEST((right_normal(Vec2d{1, 0}) == Vec2d{0, -1}));
    BOOST_TEST(cross(Vec2d{1, 0}, Vec2d{0, 1}) == 1);
}
