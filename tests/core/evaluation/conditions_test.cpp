// SPDX-License-Identifier: MIT
#include "evaluation/conditions.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(refinement_keeps_every_duration_in_time_units) {
    const Parameters whole, half = refined(whole, 2);
    const auto time = [](const Parameters &p, double steps) { return steps * p.development.time_step; };
    BOOST_TEST(half.development.time_step == 0.005);
    for (const auto duration : {&SettlingParameters::settle_window, &SettlingParameters::settle_limit})
        BOOST_TEST(time(half, half.settling.*duration) == time(whole, whole.settling.*duration));
    for (const auto duration :
         {&GaitParameters::locomotion_steps, &GaitParameters::ramp_steps, &GaitParameters::knot_interval,
          &GaitParameters::update_interval, &GaitParameters::path_interval})
        BOOST_TEST(time(half, half.gait.*duration) == time(whole, whole.gait.*duration));
    BOOST_TEST(time(half, half.gait.period_shortest) == time(whole, whole.gait.period_shortest));
    BOOST_TEST(time(half, half.gait.period_longest) == time(whole, whole.gait.period_longest));
    // The guard is a speed: cells per step, so half of it.
    BOOST_TEST(half.body.node_speed_limit / half.development.time_step ==
               whole.body.node_speed_limit / whole.development.time_step);
    check_consistency(half);
}

BOOST_AUTO_TEST_CASE(refinement_changes_no_other_parameter) {
    const Parameters whole;
    const Parameters half = refined(whole, 2);
    int changed = 0;
    for (const ParameterRow &row : parameter_rows())
        changed += parameter(half, row.name) != parameter(whole, row.name);
    BOOST_TEST(changed == 11);
}
