// SPDX-License-Identifier: MIT
// The native engine on whole bodies: rest, carriage by a current, and its guard.
#include "physics/native/native_engine.h"

#include "physics/embody.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <limits>

using namespace planula;
using namespace planula::specimens;

namespace {

Vec2d momentum(const NativeEngine &engine) {
    Vec2d sum;
    for (const Vec2d v : engine.velocities()) sum += v;
    return sum;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_body_in_equilibrium_stays_where_it_is) {
    const auto model = embody(lattice(6, 3), water(), Parameters{});
    const Environment environment = water();
    NativeEngine engine;
    engine.load(model, environment);
    for (int i = 0; i < 1000; ++i) engine.step(model.rest_lengths, 0);
    for (std::size_t i = 0; i < model.positions.size(); ++i)
        BOOST_TEST(length(engine.positions()[i] - model.positions[i]) < 1e-4);
}

BOOST_AUTO_TEST_CASE(a_current_carries_a_body_along) {
    Environment environment = water();
    environment.flow = {2, 0};
    const auto model = embody(lattice(5, 2), environment, Parameters{});
    NativeEngine engine;
    engine.load(model, environment);
    for (int t = 0; t < 4000; ++t) engine.step(model.rest_lengths, 0);
    const Vec2d drift = momentum(engine) / static_cast<double>(model.nodes());
    BOOST_TEST(drift.x > 1.5);
    BOOST_TEST(drift.x < 2);
}

BOOST_AUTO_TEST_CASE(speeds_beyond_the_guard_and_numbers_that_are_not_are_explosions) {
    const auto model = embody(lattice(3, 2), water(), Parameters{});
    const Environment environment = water();
    NativeEngine engine;
    engine.load(model, environment);
    std::vector<double> wild(model.rest_lengths.size(), 1e6);
    BOOST_TEST(engine.step(wild, 0).exploded);
    engine.load(model, environment);
    std::vector<double> broken = model.rest_lengths;
    broken[0] = std::numeric_limits<double>::quiet_NaN();
    BOOST_TEST(engine.step(broken, 0).exploded);
    engine.load(model, environment);
    BOOST_TEST(!engine.step(model.rest_lengths, 0).exploded);
}
