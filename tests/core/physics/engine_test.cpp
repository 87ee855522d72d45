// SPDX-License-Identifier: MIT
// What every engine must do: rest, muscles, ground, currents and the guard.
#include "physics/engine.h"

#include "base/error.h"
#include "physics/embody.h"
#include "support/motion.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace planula;
using namespace planula::specimens;

namespace {

/// A lattice of two rows of six, which a current of 0.5 cells/t.u. does not bend.
Body plate() {
    std::vector<Vec2d> corners;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 2; ++j) corners.push_back({static_cast<double>(i), static_cast<double>(j)});
    return make_body(corners, 1.5);
}

} // namespace

BOOST_AUTO_TEST_CASE(engines_are_made_by_name) {
    for (const std::string_view name : engine_names()) BOOST_TEST(make_engine(name) != nullptr);
    BOOST_CHECK_EXCEPTION(make_engine("bulet"), InputError, [](const InputError &error) {
        return std::string(error.what()) == "there is no engine 'bulet'; did you mean 'bullet'?";
    });
    BOOST_CHECK_EXCEPTION(make_engine("referense"), InputError, [](const InputError &error) {
        return std::string(error.what()) == "there is no engine 'referense'; did you mean 'reference'?";
    });
}

BOOST_AUTO_TEST_CASE(a_body_in_equilibrium_stays_where_it_is) {
    const Environment environment = water();
    const auto model = soft_body(lattice(6, 3), environment);
    for (const std::string_view name : engine_names()) {
        const auto engine = loaded(name, model, environment);
        for (int i = 0; i < 1000; ++i) engine->step(0);
        BOOST_TEST(farthest_apart(engine->positions(), model.positions) < (name == "native" ? 1e-4 : 1e-9),
                   name);
    }
}

BOOST_AUTO_TEST_CASE(rest_lengths_go_linearly_from_knot_to_knot_and_stay_there) {
    // A pair of cells, heavily damped, follows its rest length.
    const Environment environment = empty_space();
    auto model = soft_body(lattice(2, 1), environment);
    model.body.spring_stiffness = 4000, model.body.spring_damping = 50;
    for (const std::string_view name : engine_names()) {
        const auto engine = loaded(name, model, environment);
        const auto length_after = [&](int steps) {
            for (int i = 0; i < steps; ++i) engine->step(0);
            return length(engine->positions()[1] - engine->positions()[0]);
        };
        engine->actuate(std::vector<double>(2, 0.1), 1000);
        BOOST_TEST(std::abs(length_after(500) - 1.1) < 0.01, name);
        BOOST_TEST(std::abs(length_after(500) - 1.2) < 0.01, name);
        BOOST_TEST(std::abs(length_after(500) - 1.2) < 1e-5, name);
        engine->actuate(std::vector<double>(2, -0.1), 1);
        BOOST_TEST(std::abs(length_after(500) - 0.8) < 1e-5, name);
    }
}

BOOST_AUTO_TEST_CASE(a_dropped_body_comes_to_rest_on_the_ground) {
    const Environment environment = land();
    auto model = soft_body(lattice(6, 3), environment);
    for (Vec2d &p : model.positions) p.y += 1;
    for (const std::string_view name : engine_names()) {
        const auto engine = loaded(name, model, environment);
        Motion motion;
        for (int t = 0; t < 3000; ++t) motion = engine->step(1);
        BOOST_TEST(motion.fastest < 0.05, name);
        double lowest = 1e9;
        for (const Vec2d p : engine->positions()) lowest = std::min(lowest, p.y);
        BOOST_TEST(std::abs(lowest) < 0.01, name << ": " << lowest);
    }
}

BOOST_AUTO_TEST_CASE(a_body_slides_only_on_a_slope_steeper_than_its_friction) {
    for (const std::string_view name : engine_names())
        for (const double steepness : {0.7, 0.9}) {
            Environment environment = land();
            environment.ground = {{-1000, -1000 * steepness}, {1000, 1000 * steepness}};
            Body body = lattice(8, 2);
            const double c = 1 / std::sqrt(1 + steepness * steepness), s = steepness * c;
            for (Vec2d &p : body.positions) p = {c * p.x - s * p.y, s * p.x + c * p.y};
            const auto model = soft_body(body, environment);
            const auto engine = loaded(name, model, environment);
            for (int t = 0; t < 2000; ++t) engine->step(0);
            const double slid = -centre_of_mass(engine->positions()).x;
            BOOST_TEST((steepness < 0.8 ? slid < 0.3 : slid > 3), name << " slid by " << slid);
        }
}

BOOST_AUTO_TEST_CASE(a_wall_stops_a_body_that_slides_into_it) {
    // Down a slope without friction, at up to 12 cells/t.u.
    const Environment environment{
        .gravity = 5, .has_ground = true, .ground = {{-20, 10}, {10, -5}, {11, 5}, {60, 5}}};
    const auto model = soft_body(lattice(4, 3), environment);
    for (const std::string_view name : engine_names()) {
        const auto engine = loaded(name, model, environment);
        double farthest = 0;
        for (int t = 0; t < 2000; ++t) {
            BOOST_REQUIRE(!engine->step(0).exploded);
            farthest = std::max(farthest, centre_of_mass(engine->positions()).x);
        }
        BOOST_TEST(farthest > 8, name << ": " << farthest);
        BOOST_TEST(farthest < 11, name << ": " << farthest);
    }
}

BOOST_AUTO_TEST_CASE(a_current_carries_a_body_along) {
    Environment environment = water();
    environment.flow = {2, 0};
    const auto model = soft_body(lattice(5, 2), environment);
    for (const std::string_view name : engine_names()) {
        const auto engine = loaded(name, model, environment);
        for (int t = 0; t < 4000; ++t) engine->step(0);
        const Vec2d drift = centre_of_mass(engine->velocities());
        BOOST_TEST(drift.x > 1.5, name);
        BOOST_TEST(drift.x < 2, name);
    }
}

BOOST_AUTO_TEST_CASE(a_plate_in_a_current_gains_speed_as_quadratic_drag_demands) {
    // The speed relative to the water is u / (1 + K u t / m), with K from both long faces and both ends.
    Environment environment = water();
    environment.flow = {0, 0.5};
    const auto model = soft_body(plate(), environment);
    const double K = 1.0 * 2 * 5 + 0.1 * 2 * 1, mass = 12;
    for (const std::string_view name : engine_names()) {
        const auto engine = loaded(name, model, environment);
        double worst = 0;
        for (int t = 1; t <= 1000; ++t) {
            BOOST_REQUIRE(!engine->step(0).exploded);
            const double left = 0.5 - centre_of_mass(engine->velocities()).y;
            worst = std::max(worst, std::abs(left * (1 + K * 0.5 * (0.01 * t) / mass) / 0.5 - 1));
        }
        BOOST_TEST(worst < 0.01, name << ": " << worst);
    }
}

BOOST_AUTO_TEST_CASE(speeds_over_the_limit_and_nan_are_explosions) {
    const Environment environment = water();
    const auto model = soft_body(lattice(3, 2), environment);
    const std::vector<double> wild(model.positions.size(), 1e6);
    std::vector<double> broken(model.positions.size());
    broken[0] = std::numeric_limits<double>::quiet_NaN();
    for (const std::string_view name : engine_names()) {
        const auto engine = loaded(name, model, environment);
        BOOST_TEST(step_with(wild, *engine).exploded, name);
        engine->load(model, environment);
        BOOST_TEST(step_with(broken, *engine).exploded, name);
        engine->load(model, environment);
        BOOST_TEST(!engine->step(0).exploded, name);
    }
}
