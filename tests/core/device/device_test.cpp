// SPDX-License-Identifier: MIT
// The device's trials are those of locomote(), to the bit, in whatever order its threads work.
#include "device/device.h"

#include "base/error.h"
#include "base/parallel.h"
#include "physics/native/native_engine.h"
#include "support/emulated_device.h"
#include "support/print.h"
#include "support/specimens.h"
#include "support/trials.h"

#include <boost/test/unit_test.hpp>

#include <functional>
#include <string>

using namespace planula;
using namespace planula::specimens;
using namespace planula::test;

namespace {

/// Short, and with steps that are no multiples of each other.
Parameters short_trial() {
    Parameters p;
    p.settling.settle_window = 60, p.settling.settle_limit = 700;
    p.gait.locomotion_steps = 605, p.gait.path_interval = 55;
    return p;
}

Environment hills() {
    Environment environment = land();
    environment.ground = {{-5, 0}, {-1, 0.5}, {0, 0}, {2, -1}, {6, 1}, {30, 2}};
    return environment;
}

/// Land under a shallow current, of another height.
Environment brook() {
    Environment environment = land();
    environment.ground = {{-1, 3.7}, {1, 3.7}};
    environment.drag_normal = 0.7, environment.drag_tangential = 0.2, environment.flow = {0.6, 0.1};
    return environment;
}

using MakeGait = std::function<std::unique_ptr<Gait>(const Body &, const Parameters &)>;

/// Compares the trial of this body with that of the engine, in every order of threads.
Trial compare(const std::string &name, const Body &body, const Environment &environment, double range,
              const Parameters &p, const MakeGait &make_gait) {
    const SoftBodyModel model = soft_body(body, environment, p);
    NativeEngine engine;
    const Trial expected = locomote(model, environment, range, p, *make_gait(body, p), engine);
    for (const Order order : {Order::forward, Order::backward, Order::mixed}) {
        Device device(std::make_unique<EmulatedRunner>(order));
        const auto trial = device.locomote(model, environment, range, p, *make_gait(body, p));
        BOOST_TEST_REQUIRE(trial.has_value(), name);
        BOOST_TEST(same(*trial, expected), name << ", order " << static_cast<int>(order));
    }
    return expected;
}

} // namespace

BOOST_AUTO_TEST_CASE(bodies_move_as_with_the_native_engine) {
    const Networks networks;
    const Parameters p = short_trial();
    const std::pair<std::string, Environment> worlds[]{{"water", water()},
                                                       {"land", land()},
                                                       {"hills", hills()},
                                                       {"brook", brook()},
                                                       {"space", empty_space()}};
    const std::pair<std::string, Body> bodies[]{
        {"lattice", lattice(5, 4)}, {"hook", hook()}, {"arms", two_arms(2)}};
    int moved = 0;
    for (const auto &[world, environment] : worlds)
        for (const auto &[shape, body] : bodies) {
            const Trial swing = compare(shape + " in " + world, body, environment, 0.4, p, oscillators);
            const Trial update =
                compare(shape + " with networks in " + world, body, environment, 0.6, p,
                        [&](const Body &b, const Parameters &q) { return networks.gait(b, q); });
            moved += swing.outcome == Outcome::viable && swing.rest != swing.finish;
            moved += update.outcome == Outcome::viable && update.activity > 0;
        }
    BOOST_TEST(moved > 15);
}

BOOST_AUTO_TEST_CASE(bodies_that_touch_themselves_move_as_with_the_native_engine) {
    // Arms that bend far, so that pairs are listed, measured and pushed apart.
    Parameters p = short_trial();
    p.gait.locomotion_steps = 1000;
    Parameters without = p;
    without.body.contact_stiffness = 0;
    int touching = 0;
    for (const auto &[name, body] :
         {std::pair("u", u_body(2, 3)), {"spiral", spiral_body(2)}, {"arms", two_arms(3)}})
        for (const Environment &environment : {water(), land()})
            touching += !same(compare(name, body, environment, 0.8, p, oscillators),
                              compare(name, body, environment, 0.8, without, oscillators));
    BOOST_TEST(touching >= 3);
}

BOOST_AUTO_TEST_CASE(ends_that_come_early_are_the_same) {
    const Body body = lattice(5, 4);
    Parameters p = short_trial();
    p.body.spring_stiffness = 4000, p.body.pressure_stiffness = 5000, p.body.spring_damping = 0;
    const Trial burst = compare("burst", body, water(), 0.9, p, oscillators);
    BOOST_TEST((burst.outcome == Outcome::exploded));

    p = short_trial();
    p.body.node_speed_limit = 0.01;
    BOOST_TEST((compare("fast", body, water(), 0.9, p, oscillators).outcome == Outcome::exploded));
    Environment fall = land();
    fall.gravity = 100;
    BOOST_TEST((compare("fall", body, fall, 0.3, p, oscillators).outcome == Outcome::exploded));
    p = short_trial();
    p.settling.settle_speed = 0;
    BOOST_TEST((compare("restless", body, land(), 0.3, p, oscillators).outcome == Outcome::never_settled));

    // An activation that is not a number.
    p = short_trial();
    Networks networks;
    networks.network.sources[0].weight = std::numeric_limits<double>::quiet_NaN();
    const auto gait = [&](const Body &b, const Parameters &q) { return networks.gait(b, q); };
    BOOST_TEST((compare("unsound", body, water(), 0.3, p, gait).outcome == Outcome::exploded));
}

BOOST_AUTO_TEST_CASE(what_the_device_does_not_simulate_is_left_to_the_caller) {
    const Body body = lattice(5, 4);
    const Parameters p = short_trial();
    Device device(std::make_unique<EmulatedRunner>());
    const auto takes = [&](const Environment &environment, const Parameters &parameters, const Gait &gait) {
        return device.locomote(soft_body(body, environment, p), environment, 0.3, parameters, gait)
            .has_value();
    };
    const auto gait = oscillators(body, p);
    BOOST_TEST(takes(water(), p, *gait));
    Environment other = water();
    other.obstacles = {{{{5, 5}, {6, 5}, {6, 6}}, {}}};
    BOOST_TEST(!takes(other, p, *gait));
    other = water(), other.regions = {{{}, 2, 2, {}, {}}};
    BOOST_TEST(!takes(other, p, *gait));
    other = water(), other.current.samples = {{1, 0}, {0, 0}};
    BOOST_TEST(!takes(other, p, *gait));
    other = land(), other.gravity_direction = 10;
    BOOST_TEST(!takes(other, p, *gait));
    BOOST_TEST(!takes(water(), p, *hold(oscillators(body, p), 100)));
    Parameters rising = p;
    rising.gait.gait_time = GaitTime::rising;
    BOOST_TEST(!takes(water(), rising, *Networks().gait(body, rising)));
}

BOOST_AUTO_TEST_CASE(each_of_many_threads_gets_its_own_trial) {
    const Parameters p = short_trial();
    std::vector<Body> bodies;
    for (int i = 0; i < 40; ++i) bodies.push_back(lattice(3 + i % 4, 3 + i % 7));
    const auto on_engine = [&](const Body &body) {
        NativeEngine engine;
        return locomote(soft_body(body, water(), p), water(), 0.4, p, *oscillators(body, p), engine);
    };
    Device device(std::make_unique<EmulatedRunner>());
    std::vector<char> right(bodies.size());
    parallel_for(static_cast<int>(bodies.size()), 13, [&](int i) {
        const auto trial =
            device.locomote(soft_body(bodies[i], water(), p), water(), 0.4, p, *oscillators(bodies[i], p));
        right[i] = trial && same(*trial, on_engine(bodies[i]));
    });
    BOOST_TEST(std::count(right.begin(), right.end(), 1) == 40);
}

BOOST_AUTO_TEST_CASE(a_device_that_fails_fails_every_trial_of_the_batch_and_no_other) {
    struct Failing : EmulatedRunner {
        void run(int batch, std::span<device::Job *const> jobs) override {
            if (++runs == 2) throw IoError("the device is gone");
            EmulatedRunner::run(batch, jobs);
        }
        std::atomic<int> runs = 0;
    };
    const Body body = lattice(4, 4);
    const Parameters p = short_trial();
    Device device(std::make_unique<Failing>());
    std::atomic<int> failed = 0, done = 0;
    parallel_for(20, 8, [&](int) {
        try {
            done += device.locomote(soft_body(body, water(), p), water(), 0.4, p, *oscillators(body, p))
                        .has_value();
        } catch (const IoError &) {
            ++failed;
        }
    });
    BOOST_TEST(failed > 0);
    BOOST_TEST(failed <= 3);
    BOOST_TEST(failed + done == 20);
}
