// SPDX-License-Identifier: MIT
#include "statement/schema_course.h"

#include "experiment/deciding.h"
#include "experiment/world_numbers.h"
#include "statement/schema.h"
#include "support/print.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

// `stated` is on line 2.
Spec setting(const std::string &stated, const Overrides &overrides = {}) {
    const std::string text =
        "local paper = require 'paper'\nreturn paper.experiment { name = 'x', " + stated + " }";
    return load_experiment(test::script(text), overrides).settings[0];
}

std::string refused(const std::string &stated) {
    return test::refusal([&] { setting(stated); });
}

void refuses(const std::string &stated, const std::string &message) {
    BOOST_TEST(test::contains(refused(stated), "test.lua:2: " + message), refused(stated));
}

} // namespace

BOOST_AUTO_TEST_CASE(phases_are_further_worlds) {
    const Spec spec =
        setting("phases = { { at = 1000, environment = paper.terrestrial { friction = 0.3 }, settle = true },"
                "{ at = 2000, environment = paper.aquatic() } }");
    BOOST_TEST_REQUIRE(spec.phases.size() == 2u);
    BOOST_TEST(spec.phases[0].at == 1000);
    BOOST_TEST(spec.phases[0].settles);
    BOOST_TEST(spec.phases[0].environment.friction == 0.3);
    BOOST_TEST(spec.phases[0].environment.gravity == Parameters{}.land.gravity);
    BOOST_TEST(spec.phases[0].actuation_range == Parameters{}.land.actuation_range_terrestrial);
    BOOST_TEST(!spec.phases[1].settles);
    BOOST_TEST(!spec.phases[1].environment.has_ground);
    BOOST_TEST(setting("").phases.empty());
}

BOOST_AUTO_TEST_CASE(parameters_of_the_worlds_of_phases_are_read) {
    const std::string phases = "phases = { { at = 1000, environment = paper.terrestrial(), settle = true } }";
    const Spec spec = setting(phases, {{"gravity", 2}});
    BOOST_TEST(spec.phases[0].environment.gravity == 2);
    BOOST_TEST(spec.environment.gravity == 0);
    BOOST_TEST(why_unread(parameter_row("gravity"), spec) == "");
    BOOST_TEST(why_unread(parameter_row("settle_speed"), spec) == "");
    BOOST_TEST(why_unread(parameter_row("gravity"), setting("")) != "");
    BOOST_TEST(why_unread(parameter_row("settle_speed"), setting("")) != "");
}

BOOST_AUTO_TEST_CASE(bad_phases_are_refused_on_their_line) {
    refuses("phases = { 3 }", "phases[1] must be a table");
    refuses("phases = { at = 10 }", "phases has no 'at'");
    refuses("phases = { { environment = paper.aquatic() } }", "phases[1].at is missing");
    refuses("phases = { { at = 100 } }", "phases[1].environment is missing");
    refuses("phases = { { at = 100, steps = 3, environment = paper.aquatic() } }",
            "phases[1] has no 'steps'");
    refuses("phases = { { at = 105, environment = paper.aquatic() } }",
            "phases[1].at, the step that a phase begins with, is a multiple of knot_interval (10), at least "
            "10 and less "
            "than locomotion_steps (4000), not 105");
    refuses("phases = { { at = 100, environment = paper.aquatic(), settle = true } }",
            "phases[1]: settle = true needs gravity");
    refuses("phases = { { at = 100, environment = paper.aquatic { friction = -1 } } }",
            "environment: friction must be");
}

BOOST_AUTO_TEST_CASE(damage_is_a_share_of_a_side_or_a_rectangle) {
    const Spec side = setting("damage = { at = 500, share = 0.3, side = 'middle' }");
    BOOST_TEST(side.damage->at == 500);
    BOOST_TEST(side.damage->share == 0.3);
    BOOST_TEST((side.damage->side == Side::middle));
    BOOST_TEST(!side.damage->within);
    const Spec box = setting("damage = { within = { from = 0, top = 2 } }");
    BOOST_TEST(box.damage->at == 0);
    BOOST_TEST((*box.damage->within == Box{.left = 0, .top = 2}));
    BOOST_TEST(!setting("").damage);
}

BOOST_AUTO_TEST_CASE(bad_damage_is_refused_on_its_line) {
    const std::string which = "damage states share = and side =, or within =: which cells are lost";
    refuses("damage = { at = 500 }", which);
    refuses("damage = { share = 0.5 }", which);
    refuses("damage = { side = 'left' }", which);
    refuses("damage = { share = 0.5, side = 'left', within = { from = 0 } }", which);
    refuses("damage = { share = 0.5, side = 'lift' }",
            "damage.side: 'lift' is not one of left, right, bottom, top, middle, edge, random; did you mean "
            "'left'?");
    refuses("damage = { share = 1.5, side = 'left' }",
            "damage: share is a share of the cells, 0 to 1, not 1.5");
    refuses("damage = { at = 15, share = 0.5, side = 'left' }",
            "damage.at, the step before which cells are lost,");
    refuses("damage = { within = { from = 2, to = 1 } }",
            "damage: within.from must be less than within.to, not 2");
    refuses("damage = { remove = function() end }", "damage has no 'remove'");
}
