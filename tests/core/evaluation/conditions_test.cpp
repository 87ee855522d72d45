// SPDX-License-Identifier: MIT
#include "evaluation/conditions.h"

#include "base/error.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <functional>
#include <string>

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

namespace {

std::string refusal(const std::function<void(Conditions &)> &change) {
    Conditions conditions;
    conditions.phases = {{1000, specimens::land(), 0.3, true}, {2000, specimens::water(), 0.4, false}};
    conditions.damage = Damage{.at = 500, .share = 0.5};
    change(conditions);
    try {
        check_course(conditions);
    } catch (const InputError &error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(phases_and_damage_that_make_no_sense_are_refused_with_the_rule) {
    BOOST_TEST(refusal([](Conditions &) {}).empty());
    BOOST_TEST(refusal([](Conditions &c) { c.phases[0].at = 0; }) ==
               "phases[1].at, the step that a phase begins with, is a multiple of knot_interval (10), at "
               "least 10 and "
               "less than locomotion_steps (4000), not 0");
    BOOST_TEST(
        refusal([](Conditions &c) { c.phases[1].at = 1000; }) ==
        "phases[2].at, the step that a phase begins with, is a multiple of knot_interval (10), at least 1010 "
        "and less than locomotion_steps (4000), not 1000");
    BOOST_TEST(!refusal([](Conditions &c) { c.phases[1].at = 1005; }).empty());
    BOOST_TEST(!refusal([](Conditions &c) { c.phases[1].at = 4000; }).empty());
    BOOST_TEST(refusal([](Conditions &c) { c.phases[1].settles = true; }) ==
               "phases[2]: settle = true needs gravity, without which no body settles");
    BOOST_TEST(refusal([](Conditions &c) { c.phases[1].actuation_range = 1; }) ==
               "phases[2]: actuation_range is between 0 and 0.9 rest lengths, not 1");
    BOOST_TEST(!refusal([](Conditions &c) { c.phases[1].environment.friction = -1; }).empty());
    BOOST_TEST(refusal([](Conditions &c) { c.damage->at = 4000; }) ==
               "damage.at, the step before which cells are lost, is a multiple of knot_interval (10), at "
               "least 0 and "
               "less than locomotion_steps (4000), not 4000");
    BOOST_TEST(!refusal([](Conditions &c) { c.damage->share = 2; }).empty());
}
