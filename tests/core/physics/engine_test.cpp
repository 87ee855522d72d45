// SPDX-License-Identifier: MIT
#include "physics/engine.h"

#include "base/error.h"
#include "physics/embody.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace planula;
using namespace planula::specimens;

BOOST_AUTO_TEST_CASE(engines_are_made_by_name) {
    for (const std::string_view name : engine_names()) BOOST_TEST(make_engine(name) != nullptr);
    BOOST_CHECK_EXCEPTION(make_engine("bulet"), InputError, [](const InputError &error) {
        return std::string(error.what()) == "there is no engine 'bulet'; did you mean 'bullet'?";
    });
}

BOOST_AUTO_TEST_CASE(every_engine_lets_a_body_in_equilibrium_be) {
    for (const std::string_view name : engine_names()) {
        const Environment environment = water();
        const auto model = soft_body(lattice(6, 3), environment);
        const auto engine = make_engine(name);
        engine->load(model, environment);
        for (int i = 0; i < 500; ++i) engine->step(0);
        for (std::size_t i = 0; i < model.positions.size(); ++i)
            BOOST_TEST(length(engine->positions()[i] - model.positions[i]) < 1e-4, name);
    }
}

BOOST_AUTO_TEST_CASE(every_engine_sets_a_dropped_body_on_the_ground) {
    for (const std::string_view name : engine_names()) {
        const Environment environment = land();
        auto model = soft_body(lattice(6, 3), environment);
        for (Vec2d &p : model.positions) p.y += 1;
        const auto engine = make_engine(name);
        engine->load(model, environment);
        Motion motion;
        for (int t = 0; t < 3000; ++t) motion = engine->step(1);
        BOOST_TEST(motion.fastest < 0.05, name);
        double lowest = 1e9;
        for (const Vec2d p : engine->positions()) lowest = std::min(lowest, p.y);
        BOOST_TEST(std::abs(lowest) < 0.01, name << ": " << lowest);
    }
}

BOOST_AUTO_TEST_CASE(every_engine_slides_on_a_slope_steeper_than_its_friction_only) {
    for (const std::string_view name : engine_names())
        for (const double steepness : {0.7, 0.9}) {
            Environment environment = land();
            environment.ground = {{-1000, -1000 * steepness}, {1000, 1000 * steepness}};
            Body body = lattice(8, 2);
            const double c = 1 / std::sqrt(1 + steepness * steepness), s = steepness * c;
            for (Vec2d &p : body.positions) p = {c * p.x - s * p.y, s * p.x + c * p.y};
            const auto model = soft_body(body, environment);
            const auto engine = make_engine(name);
            engine->load(model, environment);
            for (int t = 0; t < 2000; ++t) engine->step(0);
            const double slid = -centre_of_mass(engine->positions()).x;
            BOOST_TEST((steepness < 0.8 ? slid < 0.3 : slid > 3), name << " slid by " << slid);
        }
}

BOOST_AUTO_TEST_CASE(every_engine_notices_an_explosion) {
    for (const std::string_view name : engine_names()) {
        const Environment environment = water();
        const auto model = soft_body(lattice(3, 2), environment);
        const auto engine = make_engine(name);
        engine->load(model, environment);
        engine->actuate(std::vector<double>(model.positions.size(), 1e6), 1);
        BOOST_TEST(engine->step(0).exploded);
    }
}
