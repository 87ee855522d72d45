// SPDX-License-Identifier: MIT
// Fields that differ from place to place and from time to time, in every engine (decision 0025).
#include "physics/fields.h"

#include "base/error.h"
#include "base/math.h"
#include "physics/embody.h"
#include "support/lockstep.h"
#include "support/motion.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>
#include <string>

using namespace planula;
using namespace planula::specimens;

namespace {

Region everywhere(const Environment &environment) {
    return {{}, environment.drag_normal, environment.drag_tangential, environment.flow, {}};
}

/// Land on the left, water on the right below y = 1 that carries a body, in a current of its own.
Environment shore() {
    Environment environment = land();
    environment.ground = {{-30, 2}, {-2, 2}, {4, -6}, {60, -6}};
    environment.regions = {{{0, 60, -9, 1}, 1, 0.1, Vec2d{0.4, -0.1}, {}},
                           {{-99, 99, 0.5, 3}, 0.5, 0.2, {}, {}}};
    environment.regions.push_back({.box = {.top = 1}, .buoyancy = 0.9});
    return environment;
}

/// A body in motion in an engine, muscles swinging, for so many steps.
std::vector<Vec2d> swum(Engine &engine, const SoftBodyModel &model, const Environment &environment,
                        int steps) {
    engine.load(model, environment);
    for (int t = 0; t < steps; ++t) step_with(swinging(model, 0.01 * t), engine);
    return engine.positions();
}

std::string refusal(const std::function<void(Environment &)> &change) {
    Environment environment = land();
    change(environment);
    try {
        check_environment(environment);
    } catch (const InputError &error) {
        return error.what();
    }
    return "";
}

Vec2d turned(Vec2d v, double degrees) {
    const double angle = degrees * math::pi / 180, c = math::cos(angle), s = math::sin(angle);
    return {c * v.x - s * v.y, s * v.x + c * v.y};
}

} // namespace

BOOST_AUTO_TEST_CASE(gravity_turns_counter_clockwise_from_straight_down) {
    BOOST_TEST(gravity_vector(5, 0) == (Vec2d{0, -5}));
    BOOST_TEST(length(gravity_vector(2, 30) - Vec2d{1, -std::sqrt(3.0)}) < 1e-12);
    BOOST_TEST(length(gravity_vector(2, -30) - Vec2d{-1, -std::sqrt(3.0)}) < 1e-12);
}

BOOST_AUTO_TEST_CASE(a_current_goes_linearly_from_sample_to_sample_and_repeats_or_holds) {
    Current current{{{0, 0}, {1, 2}, {3, 2}}, 10, false};
    BOOST_TEST(current.at(0) == (Vec2d{0, 0}));
    BOOST_TEST(current.at(5) == (Vec2d{0.5, 1}));
    BOOST_TEST(current.at(10) == (Vec2d{1, 2}));
    BOOST_TEST(current.at(15) == (Vec2d{2, 2}));
    BOOST_TEST(current.at(25) == (Vec2d{3, 2}));
    BOOST_TEST(current.at(1e6) == (Vec2d{3, 2}));
    current.repeats = true;
    BOOST_TEST(current.at(25) == (Vec2d{1.5, 1}));
    BOOST_TEST(current.at(30) == (Vec2d{0, 0}));
    BOOST_TEST(current.at(3000035) == (Vec2d{0.5, 1}));
}

BOOST_AUTO_TEST_CASE(fields_that_make_no_sense_are_refused_with_the_rule) {
    const double inf = std::numeric_limits<double>::infinity();
    BOOST_TEST(refusal([](Environment &e) { e.gravity_direction = 95; }) ==
               "environment: gravity_direction is between -90 and 90 degrees from straight down, so that "
               "bodies fall "
               "onto the ground, not 95");
    BOOST_TEST(!refusal([](Environment &e) { e.gravity_direction = std::nan(""); }).empty());
    BOOST_TEST(refusal([](Environment &e) { e.regions = {{.box = {.left = 3, .right = 2}}}; }) ==
               "environment: regions[1]: from must be less than to (2), not 3");
    BOOST_TEST(refusal([](Environment &e) {
                   e.regions = {{}, {.box = {.bottom = 3, .top = 3}}};
               }) == "environment: regions[2]: bottom must be less than top (3), not 3");
    BOOST_TEST(refusal([](Environment &e) { e.regions = {{.drag_normal = -1}}; }) ==
               "environment: regions[1]: drag must be a finite number, 0 or more, not -1");
    BOOST_TEST(refusal([&](Environment &e) {
                   e.regions = {{.flow = Vec2d{0, inf}}};
               }) == "environment: regions[1]: flow must be finite, not inf");
    BOOST_TEST(refusal([](Environment &e) { e.regions = {{.buoyancy = 1.5}}; }) ==
               "environment: regions[1]: buoyancy is a share of gravity, 0 to 1, not 1.5");
    BOOST_TEST(refusal([](Environment &e) { e.regions = {{.box = {.left = 3}, .buoyancy = 1}}; }) ==
               "environment: regions[1]: a region with buoyancy has no from and no to, for a body that rose "
               "inside and "
               "fell outside would gain energy: let the ground hold the water, not 3");
    BOOST_TEST(
        refusal([](Environment &e) {
            e.regions = {{.buoyancy = 1}};
            e.gravity_direction = 10;
        }) ==
        "environment: water that carries a body (buoyancy) is level: gravity_direction must be 0, not 10");
    BOOST_TEST(refusal([](Environment &e) { e.regions.resize(101); }) ==
               "environment: there are at most 100 regions, not 101");
    BOOST_TEST(refusal([&](Environment &e) {
                   e.current.samples = {{0, inf}};
               }) == "environment: flow must be finite, not inf");
    BOOST_TEST(refusal([](Environment &e) { e = shore(); }).empty());
}

BOOST_AUTO_TEST_CASE(a_region_that_is_everywhere_is_the_same_as_none_to_the_bit) {
    Environment plain = water();
    plain.flow = {0.5, -0.25};
    Environment divided = plain;
    divided.regions = {everywhere(plain)};
    divided.drag_normal = 7, divided.flow = {9, 9}; // of nowhere
    Environment inherited = plain;
    inherited.regions = {everywhere(plain)};
    inherited.regions[0].flow.reset();
    const auto model = soft_body(hook(), plain);
    for (const std::string_view name : engine_names()) {
        const auto expected = swum(*make_engine(name), model, plain, 200);
        BOOST_TEST(swum(*make_engine(name), model, divided, 200) == expected, name);
        BOOST_TEST(swum(*make_engine(name), model, inherited, 200) == expected, name);
    }
}

BOOST_AUTO_TEST_CASE(no_buoyancy_is_the_same_as_none_to_the_bit) {
    Environment carried = land();
    carried.regions = {{.buoyancy = 0}};
    const auto model = soft_body(lattice(5, 3), land());
    for (const std::string_view name : engine_names())
        BOOST_TEST(swum(*make_engine(name), model, carried, 200) ==
                       swum(*make_engine(name), model, land(), 200),
                   name);
}

BOOST_AUTO_TEST_CASE(the_first_region_that_holds_a_link_decides_its_fluid) {
    // A pair of cells that drifts through still water with two overlapping regions.
    const Environment environment{.regions = {{{4, 6, -1, 1}, 0, 0, {}, {}}, {{2, 8, -1, 1}, 1, 1, {}, {}}}};
    const auto model = soft_body(lattice(2, 1), environment);
    for (const std::string_view name : engine_names()) {
        const auto engine = make_engine(name);
        engine->load(model, environment, {model.positions, {{1, 0}, {1, 0}}});
        double before = 1;
        for (int t = 0; t < 1500; ++t) {
            const double x = centre_of_mass(engine->positions()).x; // the middle of the link
            engine->step(0);
            const double speed = centre_of_mass(engine->velocities()).x;
            const bool is_slowed = (2.001 < x && x < 3.999) || (6.001 < x && x < 7.999);
            const bool is_free = x < 1.999 || (4.001 < x && x < 5.999) || 8.001 < x;
            if (is_slowed) BOOST_REQUIRE_MESSAGE(speed < before - 1e-5, name << " at " << x);
            if (is_free) BOOST_REQUIRE_MESSAGE(std::abs(speed - before) < 1e-6, name << " at " << x);
            before = speed;
        }
        BOOST_TEST(centre_of_mass(engine->positions()).x > 4, name);
    }
}

BOOST_AUTO_TEST_CASE(tilted_gravity_is_a_turned_world) {
    for (const double degrees : {20.0, -35.0}) {
        // The same body, ground and gravity, all turned against each other.
        Environment tilted = land();
        tilted.gravity_direction = degrees;
        const auto model = soft_body(lattice(6, 3), tilted);
        Environment slope = land();
        const Vec2d far = turned({1000, 0}, -degrees);
        slope.ground = {-far, far};
        auto turned_model = model;
        for (Vec2d &p : turned_model.positions) p = turned(p, -degrees);
        for (const std::string_view name : engine_names())
            for (const double height : {0.0, 9.0}) {
                BodyState state = at_rest(model);
                for (Vec2d &p : state.positions) p.y += height;
                BodyState turned_state = state;
                for (Vec2d &p : turned_state.positions) p = turned(p, -degrees);
                const auto a = make_engine(name), b = make_engine(name);
                a->load(model, tilted, state), b->load(turned_model, slope, turned_state);
                for (int t = 0; t < 150; ++t) {
                    step_with(swinging(model, 0.01 * t), *a), step_with(swinging(model, 0.01 * t), *b);
                }
                std::vector<Vec2d> back = b->positions();
                for (Vec2d &p : back) p = turned(p, degrees);
                const double apart = farthest_apart(a->positions(), back);
                BOOST_TEST(apart < (height > 0 ? 1e-4 : 0.02), name << ", " << degrees << ": " << apart);
            }
    }
}

BOOST_AUTO_TEST_CASE(water_that_carries_a_body_gives_it_no_energy) {
    // A body falls through a surface and bounces on springs of its own; the ground is far below.
    Environment environment{.gravity = 5, .has_ground = true, .ground = {{-100, -500}, {100, -500}}};
    environment.regions = {{.box = {.bottom = -4, .top = 0}, .buoyancy = 1},
                           {.box = {.top = -2}, .buoyancy = 0.5}};
    const auto model = soft_body(lattice(4, 3), environment);
    const auto potential = [](double y) { // of the layers: 5 above 0, 0 above -4, 2.5 below
        return y > 0 ? 5 * y : y > -4 ? 0 : 2.5 * (y + 4);
    };
    for (const std::string_view name : engine_names()) {
        BodyState state = at_rest(model);
        for (Vec2d &p : state.positions) p.y += 502;
        for (Vec2d &v : state.velocities) v = {0.5, 3};
        const auto engine = make_engine(name);
        engine->load(model, environment, state);
        const auto energy = [&] {
            double sum = kinetic_energy(engine->velocities());
            for (const Vec2d p : engine->positions()) sum += potential(p.y);
            return sum;
        };
        const double first = energy();
        for (int t = 0; t < 800; ++t) {
            engine->step(0);
            BOOST_REQUIRE_MESSAGE(energy() < first * 1.002, name << ": " << energy() << " of " << first);
        }
        BOOST_TEST(energy() > first * 0.97, name);
        BOOST_TEST(centre_of_mass(engine->positions()).y < -10, name);
    }
}

BOOST_AUTO_TEST_CASE(the_native_engine_computes_what_the_reference_engine_says_in_every_field) {
    Environment tilted = land(), moving = water();
    tilted.gravity_direction = -25;
    moving.current = {{{0, 0}, {1, -0.5}}, 20, true};
    for (const auto &[name, environment] :
         {std::pair("shore", shore()), {"tilted", tilted}, {"current", moving}}) {
        Lockstep lockstep;
        for (const Body &body : {hook(), spiral_body(2), two_arms(3), lattice(9, 4)}) {
            const auto model = soft_body(body, environment);
            lockstep.load(model, environment);
            for (int t = 0; t < 500; ++t) {
                if (environment.current.changes()) lockstep.set_flow(environment.flow_at(t));
                if (t % 10 == 0) lockstep.actuate(swinging(model, 0.01 * t), 10);
                if (lockstep.step(0).exploded) break;
            }
        }
        const auto [velocity, position] = rounding_bound(environment);
        BOOST_TEST(lockstep.steps > 1000, name);
        BOOST_TEST(lockstep.position_error < position, name);
        BOOST_TEST(lockstep.velocity_error < velocity, name);
    }
}

BOOST_AUTO_TEST_CASE(bullet_agrees_with_the_reference_engine_in_every_field) {
    Environment tilted = land(), moving = water();
    tilted.gravity_direction = -25;
    moving.current = {{{0, 0}, {1, -0.5}}, 20, true};
    for (const auto &[name, environment] :
         {std::pair("shore", shore()), {"tilted", tilted}, {"current", moving}}) {
        const auto model = soft_body(lattice(6, 3), environment);
        const auto bullet = loaded("bullet", model, environment),
                   reference = loaded("reference", model, environment);
        for (int t = 0; t < 300; ++t)
            for (Engine *engine : {bullet.get(), reference.get()}) {
                if (environment.current.changes()) engine->set_flow(environment.flow_at(t));
                step_with(swinging(model, 0.01 * t), *engine);
            }
        const double apart =
            length(centre_of_mass(bullet->positions()) - centre_of_mass(reference->positions()));
        BOOST_TEST(apart < (environment.has_ground ? 0.2 : 1e-6), name << ": " << apart);
    }
}

BOOST_AUTO_TEST_CASE(a_body_that_is_loaded_in_motion_goes_on) {
    for (const Environment &environment : {water(), land()}) {
        const auto model = soft_body(hook(), environment);
        for (const std::string_view name : engine_names()) {
            const auto whole = loaded(name, model, environment), second = make_engine(name);
            for (int t = 0; t < 100; ++t) step_with(swinging(model, 0.01 * t), *whole);
            second->load(model, environment, {whole->positions(), whole->velocities()});
            second->actuate(swinging(model, 0.99), 1);
            for (int t = 100; t < 150; ++t) {
                const auto extensions = swinging(model, 0.01 * t);
                step_with(extensions, *whole), step_with(extensions, *second);
            }
            const double apart = farthest_apart(whole->positions(), second->positions());
            BOOST_TEST(apart < (name == "native" ? 1e-3 : 1e-9), name << ": " << apart);
        }
    }
}
