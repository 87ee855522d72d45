// SPDX-License-Identifier: MIT
#include "body/body.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(rest_lengths_and_areas_are_those_of_the_positions) {
    const Body body = make_body({{0, 0}, {1, 0}, {0, 1}}, 1.5);
    BOOST_TEST(body.cells() == 3);
    BOOST_TEST(body.rest_lengths[0] == 1);
    BOOST_TEST(body.rest_lengths[2] == std::sqrt(2.0));
    BOOST_TEST(body.areas.at(0) == 0.5);
    BOOST_TEST(body.outline.size() == 3u);
}

BOOST_AUTO_TEST_CASE(elongation_is_the_ratio_of_the_principal_axes_at_any_angle) {
    // Two by one cells of variance 4 and 1, turned by 30 degrees.
    const double c = std::sqrt(3.0) / 2, s = 0.5;
    std::vector<Vec2d> points;
    for (const Vec2d p : {Vec2d{2, 0}, {-2, 0}, {0, 1}, {0, -1}})
        points.push_back({c * p.x - s * p.y + 7, s * p.x + c * p.y - 3});
    BOOST_TEST(elongation(points) == 2, boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_chain_has_the_largest_elongation_and_a_pair_has_none) {
    BOOST_TEST(elongation(std::vector<Vec2d>{{0, 0}, {1, 1}, {2, 2}}) == 1000);
    BOOST_TEST(elongation(std::vector<Vec2d>{{0, 0}, {1, 1}}) == 0);
}

BOOST_AUTO_TEST_CASE(the_centre_of_nothing_is_the_origin) {
    BOOST_TEST((centre_of_mass({}) == Vec2d{}));
    BOOST_TEST((centre_of_mass(std::vector<Vec2d>{{1, 2}, {3, 6}}) == Vec2d{2, 4}));
}

BOOST_AUTO_TEST_CASE(a_rigid_motion_has_no_unrest) {
    // Drift (3, -1) and a turn of 2 about the centre; then one of them also moves within the body.
    const std::vector<Vec2d> points{{1, 0}, {-1, 0}, {0, 2}, {0, -2}};
    std::vector<Vec2d> velocities;
    for (const Vec2d p : points) velocities.push_back(Vec2d{3, -1} + Vec2d{-p.y, p.x} * 2.0);
    BOOST_TEST(unrest(points, velocities) < 1e-12);
    velocities[0].x += 0.4, velocities[1].x -= 0.4;
    BOOST_TEST(unrest(points, velocities) == 0.4, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(unrest({}, {}) == 0);
}
