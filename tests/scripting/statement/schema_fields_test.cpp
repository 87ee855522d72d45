// SPDX-License-Identifier: MIT
#include "statement/schema_fields.h"

#include "experiment/world_numbers.h"
#include "statement/schema.h"
#include "support/print.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

// The environment is on line 2.
Spec setting(const std::string &environment, const Overrides &overrides = {}) {
    const std::string text =
        "local paper = require 'paper'\nreturn paper.experiment { name = 'x', environment = " + environment +
        " }";
    return load_experiment(test::script(text), overrides).settings[0];
}

std::string refused(const std::string &environment) {
    return test::refusal([&] { setting(environment); });
}

void refuses(const std::string &environment, const std::string &message) {
    BOOST_TEST(test::contains(refused(environment), "test.lua:2: " + message), refused(environment));
}

} // namespace

BOOST_AUTO_TEST_CASE(gravity_has_a_direction) {
    BOOST_TEST(setting("paper.terrestrial { gravity_direction = -20 }").environment.gravity_direction == -20);
    BOOST_TEST(setting("paper.terrestrial()").environment.gravity_direction == 0);
    refuses("paper.terrestrial { gravity_direction = 90 }",
            "environment: gravity_direction is between -90 and 90");
    refuses("paper.terrestrial { gravity_direction = 'south' }", "no parameter is called 'south'");
}

BOOST_AUTO_TEST_CASE(a_region_has_what_it_states_and_the_rest_of_the_environment) {
    const Environment e =
        setting("paper.terrestrial { drag = { normal = 3, tangential = 2 }, regions = {"
                "{ from = 1, to = 2, bottom = -3, top = 4, flow = { x = 0.5 } },"
                "{ top = 0, drag = { normal = 'drag_normal', tangential = 0.2 }, buoyancy = 0.9 } } }")
            .environment;
    BOOST_TEST_REQUIRE(e.regions.size() == 2u);
    BOOST_TEST((e.regions[0].box == Box{1, 2, -3, 4}));
    BOOST_TEST(e.regions[0].drag_normal == 3);
    BOOST_TEST(e.regions[0].drag_tangential == 2);
    BOOST_TEST((e.regions[0].flow == Vec2d{0.5, 0}));
    BOOST_TEST(!e.regions[0].buoyancy);
    BOOST_TEST((e.regions[1].box == Box{.top = 0}));
    BOOST_TEST(e.regions[1].drag_normal == Parameters{}.water.drag_normal);
    BOOST_TEST(!e.regions[1].flow);
    BOOST_TEST(*e.regions[1].buoyancy == 0.9);
}

BOOST_AUTO_TEST_CASE(a_parameter_that_only_a_region_names_makes_its_world) {
    const std::string environment =
        "paper.terrestrial { regions = { { drag = { normal = 'drag_normal', tangential = 0 } } } }";
    BOOST_TEST(makes_world("drag_normal", setting(environment)));
    BOOST_TEST(!makes_world("drag_tangential", setting(environment)));
    BOOST_TEST(setting(environment, {{"drag_normal", 7}}).environment.regions[0].drag_normal == 7);
}

BOOST_AUTO_TEST_CASE(bad_regions_are_refused_on_their_line) {
    refuses("paper.terrestrial { regions = { 3 } }", "environment.regions[1] must be a table");
    refuses("paper.terrestrial { regions = { top = 3 } }", "environment.regions has no 'top'");
    refuses("paper.terrestrial { regions = { { top = 3 } } }",
            "environment.regions[1] states no drag, no flow and no buoyancy");
    refuses("paper.terrestrial { regions = { { left = 3, buoyancy = 1 } } }",
            "environment.regions[1] has no 'left'");
    refuses("paper.terrestrial { regions = { { drag = { normal = 1 } } } }",
            "environment.regions[1].drag.tangential is missing");
    refuses("paper.terrestrial { regions = { { flow = { x = 1, step = 10 } } } }",
            "environment.regions[1].flow has no 'step'");
    refuses("paper.terrestrial { regions = { { from = 3, buoyancy = 0.5 } } }",
            "environment: regions[1]: a region with buoyancy has no from and no to");
}

BOOST_AUTO_TEST_CASE(a_flow_that_is_a_function_of_the_step_is_sampled_once) {
    const Environment held =
        setting("paper.aquatic { flow = { x = function(t) return t / 10 end, y = 2, step = 10, till = 30 } }")
            .environment;
    BOOST_TEST((held.current.samples == std::vector<Vec2d>{{0, 2}, {1, 2}, {2, 2}, {3, 2}}));
    BOOST_TEST(held.current.step == 10);
    BOOST_TEST(!held.current.repeats);
    const Environment repeated =
        setting("paper.aquatic { flow = { y = function(t) return t end, step = 50, period = 100 } }")
            .environment;
    BOOST_TEST((repeated.current.samples == std::vector<Vec2d>{{0, 0}, {0, 50}}));
    BOOST_TEST(repeated.current.repeats);
    BOOST_TEST(!setting("paper.aquatic { flow = { x = 1 } }").environment.current.changes());
}

BOOST_AUTO_TEST_CASE(a_bad_flow_is_refused_on_its_line) {
    const std::string x = "x = function(t) return t end, ";
    refuses("paper.aquatic { flow = { " + x + "} }",
            "environment.flow changes: step = is the number of physics steps");
    refuses("paper.aquatic { flow = { " + x + "step = 1.5, till = 3 } }",
            "environment.flow changes: step = is");
    refuses("paper.aquatic { flow = { " + x + "step = 10 } }", "environment.flow changes: state period =");
    refuses("paper.aquatic { flow = { " + x + "step = 10, period = 20, till = 20 } }",
            "environment.flow changes: state period =");
    refuses("paper.aquatic { flow = { " + x + "step = 10, period = 25 } }",
            "environment.flow: period = 25 must be 1 … 99999 times step = 10");
    refuses("paper.aquatic { flow = { " + x + "step = 1, till = 1e9 } }",
            "environment.flow: till = 1e+09 must be");
    refuses("paper.aquatic { flow = { x = 1, period = 20 } }",
            "environment.flow.period is of a flow that changes: x or y is a function of the step");
    refuses("paper.aquatic { flow = { x = function(t) return t / t end, step = 10, till = 20 } }",
            "environment.flow.x(0) must return a finite number");
    refuses("paper.aquatic { flow = { x = function(t) return nobody.x end, step = 10, till = 20 } }", "");
}
