// SPDX-License-Identifier: MIT
#include "evaluation/cyclic_gait.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

/// A life whose path has these places along x, one every 100 of 400 steps.
Life with_path(std::vector<double> places) {
    Life life;
    for (const double x : places) life.path.push_back({x, 0});
    life.rest = life.path.front();
    life.finish = life.path.back();
    return life;
}

GaitParameters with_steps(int locomotion_steps, int path_interval) {
    GaitParameters parameters;
    parameters.locomotion_steps = locomotion_steps;
    parameters.path_interval = path_interval;
    return parameters;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_late_share_is_what_the_last_quarter_made_of_the_displacement) {
    const GaitParameters p = with_steps(400, 100);
    BOOST_TEST(late_share(with_path({0, 1, 2, 3, 4}), p) == 0.25);
    BOOST_TEST(late_share(with_path({0, 4, 4, 4, 4}), p) == 0);
    BOOST_TEST(late_share(with_path({0, 0, 0, 0, 4}), p) == 1);
    BOOST_TEST(late_share(with_path({0, 0, 0, 8, 4}), p) == 1); // it went back
}

BOOST_AUTO_TEST_CASE(without_a_displacement_or_a_path_that_long_there_is_no_late_share) {
    const GaitParameters p = with_steps(400, 100);
    BOOST_TEST(late_share(with_path({2, 1, 0, 1, 2}), p) == 0);
    BOOST_TEST(late_share(with_path({0, 1, 2}), p) == 0);
}

BOOST_AUTO_TEST_CASE(a_quarter_between_two_points_of_the_path_begins_at_the_first) {
    // Three quarters are 270 steps.
    BOOST_TEST(late_share(with_path({0, 1, 2, 3}), with_steps(360, 100)) == 1.0 / 3);
}

BOOST_AUTO_TEST_CASE(a_cyclic_gait_keeps_the_level_of_both) {
    BOOST_TEST(is_cyclic(0.1, 0.1));
    BOOST_TEST(!is_cyclic(0.09, 0.5));
    BOOST_TEST(!is_cyclic(0.5, 0.09));
    BOOST_TEST(is_cyclic(0.2, 0.3, 0.2));
    BOOST_TEST(!is_cyclic(0.2, 0.3, 0.25));
}
