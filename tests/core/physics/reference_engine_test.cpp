// SPDX-License-Identifier: MIT
// The native engine computes what the reference engine says.
#include "physics/reference/reference_engine.h"

#include "base/random.h"
#include "physics/embody.h"
#include "support/lockstep.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <string>
#include <tuple>

using namespace planula;
using namespace planula::specimens;

namespace {

/// A triangular lattice with random gaps, its cells off their places: solid parts, holes, and bare chains.
Body random_body(std::uint64_t seed) {
    Stream stream(seed, 0, 0, Purpose::initial_weights);
    const int columns = 2 + static_cast<int>(8 * stream.uniform()),
              rows = 1 + static_cast<int>(7 * stream.uniform());
    std::vector<Vec2d> positions;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const Vec2d off{0.2 * stream.triangular(), 0.2 * stream.triangular()};
            if (stream.uniform() < 0.8)
                positions.push_back(Vec2d{column + 0.5 * (row % 2), row * 0.866} + off);
        }
    return make_body(positions.empty() ? std::vector<Vec2d>{{0, 0}} : positions, 1.5);
}

Environment hills() {
    Environment environment = land();
    environment.ground = {{-5, 0}, {-1, 0.5}, {0, 0}, {0.8, -0.4}, {0.8 + 1e-6, 0.1}, {2, -1}, {6, 1}};
    return environment;
}

Environment stream() {
    Environment environment = water();
    environment.flow = {0.5, -0.25};
    return environment;
}

/// Settles for 50 steps and swings for the others, with knots every 10 steps.
void move(Engine &engine, const Body &body, const Environment &environment, int steps) {
    const auto model = soft_body(body, environment);
    engine.load(model, environment);
    for (int t = 0; t < steps; ++t) {
        if (t >= 50 && t % 10 == 0) engine.actuate(closing(model, 0.01 * (t - 50)), 10);
        if (engine.step(t < 50 ? 1 : 0).exploded) return;
    }
}

void check(const Lockstep &lockstep, const Environment &environment, const std::string &what) {
    BOOST_TEST_MESSAGE(what << ": " << lockstep.steps << " steps, touching in " << lockstep.touching
                            << ", off by " << lockstep.position_error << " cells and "
                            << lockstep.velocity_error << " cells/t.u.");
    BOOST_TEST(lockstep.exploded_alike, what);
    BOOST_TEST(lockstep.position_error < rounding_bound(environment).position, what);
    BOOST_TEST(lockstep.velocity_error < rounding_bound(environment).velocity, what);
}

} // namespace

BOOST_AUTO_TEST_CASE(each_native_step_is_that_of_the_reference_engine) {
    for (const auto &[name, environment] :
         {std::pair("space", empty_space()), {"stream", stream()}, {"land", land()}, {"hills", hills()}}) {
        Lockstep made, random;
        for (const Body &body : {lattice(1, 1), lattice(2, 1), lattice(7, 4), hook(), u_body(1), u_body(2),
                                 spiral_body(2), two_arms(2), two_arms(3)})
            move(made, body, environment, 1500);
        for (std::uint64_t seed = 1; seed <= 40; ++seed) move(random, random_body(seed), environment, 300);
        check(made, environment, std::string("made by hand, ") + name);
        check(random, environment, std::string("random, ") + name);
        BOOST_TEST(made.touching > 100, name);
    }
}

BOOST_AUTO_TEST_CASE(trajectories_of_all_engines_stay_close) {
    // Without restarts, over 400 steps in water and over the first 200 on land. Bullet differs on the ground.
    for (const auto &[name, environment, steps] :
         {std::tuple("stream", stream(), 400), {"land", land(), 200}})
        for (const Body &body : {lattice(7, 4), hook(), two_arms(2)}) {
            const auto model = soft_body(body, environment);
            const auto native = loaded("native", model, environment);
            const auto reference = loaded("reference", model, environment);
            const auto bullet = loaded("bullet", model, environment);
            for (int t = 1; t <= steps; ++t)
                for (Engine *engine : {native.get(), reference.get(), bullet.get()})
                    step_with(swinging(model, 0.01 * t), *engine);
            const double apart = farthest_apart(native->positions(), reference->positions());
            const double of_bullet = farthest_apart(bullet->positions(), reference->positions());
            BOOST_TEST_MESSAGE(name << ", " << body.cells() << " cells: native " << apart << ", Bullet "
                                    << of_bullet << " cells apart, after moving "
                                    << farthest_apart(model.positions, reference->positions()));
            BOOST_TEST(farthest_apart(model.positions, reference->positions()) > 0.5, name);
            BOOST_TEST(apart < 1e-3, name);
            BOOST_TEST(of_bullet < (environment.has_ground ? 0.05 : 1e-9), name);
        }
}
