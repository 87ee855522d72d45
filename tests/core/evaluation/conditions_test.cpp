// SPDX-License-Identifier: MIT
#include "evaluation/conditions.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(refinement_keeps_every_duration_in_time_units) {
    const Parameters whole, half = refined(whole, 2);
    const auto time = [](const Parameters &p, double steps) { return steps * p.time_step; };
    BOOST_TEST(half.time_step == 0.005);
    for (const auto duration :
         {&Parameters::settle_window, &Parameters::settle_limit, &Parameters::locomotion_steps,
          &Parameters::ramp_steps, &Parameters::knot_interval, &Parameters::update_interval,
          &Parameters::path_interval})
        BOOST_TEST(time(half, half.*duration) == time(whole, whole.*duration));
    BOOST_TEST(time(half, half.period_shortest) == time(whole, whole.period_shortest));
    BOOST_TEST(time(half, half.period_longest) == time(whole, whole.period_longest));
    // The guard is a speed: cells per step, so half of it.
    BOOST_TEST(half.node_speed_limit / half.time_step == whole.node_speed_limit / whole.time_step);
    check_consistency(half);
}

BOOST_AUTO_TEST_CASE(nothing_else_is_refined) {
    const Parameters whole;
    const Parameters half = refined(whole, 2);
    int changed = 0;
    for (const ParameterRow &row : parameter_rows())
        changed += parameter(half, row.name) != parameter(whole, row.name);
    BOOST_TEST(changed == 11);
}
