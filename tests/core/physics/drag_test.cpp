// SPDX-License-Identifier: MIT
// Fluid drag on whole bodies against formulas.
#include "physics/laws/drag.h"

#include "base/math.h"
#include "physics/embody.h"
#include "physics/forces.h"
#include "physics/native/native_engine.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace planula;
using namespace planula::specimens;

BOOST_AUTO_TEST_CASE(drag_only_takes_energy) {
    const Environment environment = water();
    const auto model = soft_body(hook(), environment);
    Forces<double> law;
    law.load(model, environment);
    for (int sample = 0; sample < 50; ++sample) {
        std::vector<Vec2d> v, forces(model.positions.size());
        for (std::size_t i = 0; i < forces.size(); ++i)
            v.push_back({math::sin(sample + 2.0 * static_cast<double>(i)),
                         math::cos(3.0 * sample + static_cast<double>(i))});
        law.add_drag(model.positions, v, forces);
        double power = 0;
        for (std::size_t i = 0; i < v.size(); ++i) power += dot(forces[i], v[i]);
        BOOST_TEST(power < 0);
    }
}

BOOST_AUTO_TEST_CASE(the_drag_of_a_towed_chain_is_that_of_its_links) {
    // Across: λ_N L v²; along: λ_T L v², each link once.
    std::vector<Vec2d> line;
    for (int i = 0; i < 9; ++i) line.push_back({1.25 * i, 0}); // 10 long
    const Environment environment = water();
    const auto model = soft_body(make_body(line, 1.5), environment);
    Forces<double> law;
    law.load(model, environment);
    for (const Vec2d v : {Vec2d{3, 0}, Vec2d{0, -2}, Vec2d{1, 2}}) {
        const std::vector<Vec2d> together(line.size(), v);
        std::vector<Vec2d> forces(line.size());
        law.add_drag(model.positions, together, forces);
        Vec2d total;
        for (const Vec2d f : forces) total += f;
        BOOST_TEST(total.x == -0.1 * 10 * v.x * std::abs(v.x), boost::test_tools::tolerance(1e-12));
        BOOST_TEST(total.y == -1.0 * 10 * v.y * std::abs(v.y), boost::test_tools::tolerance(1e-12));
        BOOST_TEST(length(forces[0] * 2.0 - forces[4]) < 1e-12); // half to each end
    }

    // Pulled at its head until drag and pull are equal: v = √(F / (λ_T L)), L its length under tension.
    const double pull = 20, dt = 0.01;
    std::vector<Vec2d> x = model.positions, v(x.size()), forces(x.size());
    for (int t = 0; t < 10000; ++t) {
        law.compute(model.rest_lengths, x, v, forces);
        forces.back().x += pull;
        for (std::size_t i = 0; i < x.size(); ++i) v[i] += forces[i] * dt, x[i] += v[i] * dt;
    }
    const double expected = std::sqrt(pull / (0.1 * (x.back().x - x.front().x)));
    BOOST_TEST_MESSAGE("towed at " << v.front().x << ", expected " << expected);
    BOOST_TEST(v.front().x == expected, boost::test_tools::tolerance(1e-6));
}

BOOST_AUTO_TEST_CASE(a_plate_is_carried_off_by_a_current_as_quadratic_drag_demands) {
    // The speed relative to the water is u / (1 + K u t / m), with K from both long faces and both ends.
    std::vector<Vec2d> corners;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 2; ++j) corners.push_back({static_cast<double>(i), static_cast<double>(j)});
    Environment environment = water();
    environment.flow = {0, 0.5}; // too slow to bend it
    const auto model = soft_body(make_body(corners, 1.5), environment);
    NativeEngine engine;
    engine.load(model, environment);
    const double K = 1.0 * 2 * 5 + 0.1 * 2 * 1, mass = 12;
    double worst = 0;
    for (int t = 1; t <= 1000; ++t) {
        BOOST_REQUIRE(!engine.step(0).exploded);
        const double left = 0.5 - centre_of_mass(engine.velocities()).y;
        worst = std::max(worst, std::abs(left * (1 + K * 0.5 * (0.01 * t) / mass) / 0.5 - 1));
    }
    BOOST_TEST_MESSAGE("plate: worst error " << worst);
    BOOST_TEST(worst < 0.01);
}
