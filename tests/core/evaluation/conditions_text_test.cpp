// SPDX-License-Identifier: MIT
#include "evaluation/conditions_text.h"

#include "base/error.h"
#include "core/storage/temporary_folder.h"
#include "evaluation/live.h"
#include "physics/object.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

/// Everything that conditions can state.
Conditions rich() {
    Conditions c;
    c.actuation = Actuation::grn;
    c.actuation_range = 0.3;
    c.parameters.gait.locomotion_steps = 200, c.parameters.gait.gait_time = GaitTime::rising;
    c.parameters.body.spring_stiffness /= 3;
    Environment &e = c.environment;
    e = {.gravity = 1.0 / 3, .has_ground = true, .ground = {{-50, 0}, {50, 0.1}}, .friction = 0.7};
    e.flow = {0.1, -0.0};
    e.gravity_direction = -10;
    e.current = {{{0, 0}, {0.25, 0}}, 40, true};
    e.regions.push_back({.box = {.left = 3, .top = 5}, .drag_normal = 2, .flow = Vec2d{1, 0}});
    e.regions.push_back({.box = {.bottom = -4}, .drag_tangential = 0.5});
    e.obstacles.push_back({{{30, 5}, {32, 5}, {32, 8}}, 0.2});
    e.obstacles.push_back({{{-30, 5}, {-28, 5}, {-28, 8}}, std::nullopt});
    e.ceiling = {{-20, 40}, {20, 41}};
    e.friction_patches.push_back({20, 25, 0.05});
    e.object = make_object({15, 2}, 1.5);
    Environment later = specimens::water();
    later.regions.push_back({.drag_normal = 1, .buoyancy = 0.5});
    c.phases.push_back({100, later, 0.2, false});
    c.damage = Damage{.at = 50, .side = Side::middle, .within = Box{.left = 0}};
    c.refinement = 2, c.nudge = {1e-9, 3}, c.held_from = 150, c.engine = "reference";
    return c;
}

std::string refusal(const std::string &from, const std::string &to) {
    std::string text = write_conditions(rich());
    const std::size_t at = text.find(from);
    BOOST_REQUIRE(at != std::string::npos);
    return message_of<InputError>([&] { read_conditions(text.replace(at, from.size(), to)); });
}

} // namespace

BOOST_AUTO_TEST_CASE(conditions_come_back_from_their_text) {
    const Conditions c = rich();
    const std::string text = write_conditions(c);
    const Conditions back = read_conditions(text);
    BOOST_TEST(write_conditions(back) == text);
    BOOST_TEST(write_conditions({}) != text);
    BOOST_TEST(back.parameters.body.spring_stiffness == c.parameters.body.spring_stiffness);
    BOOST_TEST((back.parameters.gait.gait_time == GaitTime::rising));
    BOOST_TEST((back.environment.ground == c.environment.ground));
    BOOST_TEST((back.environment.regions.front().box == c.environment.regions.front().box));
    BOOST_TEST((back.environment.object.mesh.links == c.environment.object.mesh.links));
    BOOST_TEST((back.environment.object.areas == c.environment.object.areas));
    BOOST_TEST(back.phases.front().environment.regions.front().buoyancy.value() == 0.5);
    BOOST_TEST((back.damage->within == c.damage->within));
    BOOST_TEST(back.held_from.value() == 150);
}

BOOST_AUTO_TEST_CASE(a_life_from_texts_is_the_same) {
    Conditions c = rich();
    c.actuation = Actuation::oscillator, c.phases.clear(), c.engine = "native";
    const Genome genome = specimens::disc_genome(c.actuation);
    const Life life = live(genome, c);
    BOOST_REQUIRE((life.outcome == Outcome::viable));
    BOOST_TEST((live(genome, read_conditions(write_conditions(c))) == life));
}

BOOST_AUTO_TEST_CASE(conditions_that_break_a_rule_are_refused_with_it) {
    BOOST_TEST(refusal("actuation grn", "actuation gnr").find("line 1: 'gnr' is none of oscillator, grn") ==
               0u);
    BOOST_TEST(refusal("friction 0.7", "friction -1").find("friction must be a finite number") !=
               std::string::npos);
    BOOST_TEST(
        refusal("\nperiod_shortest 100", "\nperiod_shortest 1000").find("period_shortest is at most") !=
        std::string::npos);
    BOOST_TEST(refusal("\nperiod_shortest 100", "\nperiod_shortest 1").find("outside 2") !=
               std::string::npos);
    BOOST_TEST(refusal("gait_time rising", "gait_time risen").find("did you mean 'rising'?") !=
               std::string::npos);
    BOOST_TEST(refusal("has_ground 1", "has_ground 0").find("fall for ever") != std::string::npos);
}
