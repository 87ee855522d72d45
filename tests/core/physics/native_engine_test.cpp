// SPDX-License-Identifier: MIT
// Laws of mechanics on whole bodies: what must be conserved, and what must come to rest.
#include "physics/native/native_engine.h"

#include "physics/embody.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace planula;
using namespace planula::specimens;

namespace {

/// Rest lengths that swing by ±40 % with a phase along the links.
std::vector<double> swinging(const SoftBodyModel &model, int t) {
    std::vector<double> lengths = model.rest_lengths;
    for (std::size_t i = 0; i < lengths.size(); ++i)
        lengths[i] *= 1 + 0.4 * std::min(1.0, t / 200.0) * std::sin(t * 0.06 + 0.7 * static_cast<double>(i));
    return lengths;
}

Vec2d momentum(const NativeEngine &engine) {
    Vec2d sum;
    for (const Vec2d v : engine.velocities()) sum += v;
    return sum;
}

double angular_momentum(const NativeEngine &engine) {
    const auto x = engine.positions(), v = engine.velocities();
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) sum += cross(x[i], v[i]);
    return sum;
}

/// Sum of |v| over the nodes: the scale that momentum is compared with.
double bustle(const NativeEngine &engine) {
    double sum = 0;
    for (const Vec2d v : engine.velocities()) sum += length(v);
    return sum;
}

/// A body bent into a hook by its own rest lengths: the outer links lengthen, so that its ends collide.
Body hook() {
    std::vector<Vec2d> positions;
    for (int i = 0; i <= 12; ++i) {
        const double angle = i * 0.42;
        for (const double r : {2.4, 3.3}) positions.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
    return make_body(positions, 1.5);
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

BOOST_AUTO_TEST_CASE(nothing_pushes_itself_in_empty_space) {
    // PROMISES: momentum keeps to 1e-5 of its scale over 4000 steps with actuation on.
    const auto model = embody(lattice(7, 4), empty_space(), Parameters{});
    const Environment environment = empty_space();
    NativeEngine engine;
    engine.load(model, environment);
    double scale = 0, linear = 0, angular = 0;
    for (int t = 1; t <= 4000; ++t) {
        BOOST_REQUIRE(!engine.step(swinging(model, t), 0).exploded);
        scale = std::max(scale, bustle(engine));
        linear = std::max(linear, length(momentum(engine)));
        angular = std::max(angular, std::abs(angular_momentum(engine)));
    }
    BOOST_TEST(scale > 10);
    BOOST_TEST(linear < 1e-5 * scale);
    BOOST_TEST(angular < 1e-5 * scale * 3.5); // times the body's half length
}

BOOST_AUTO_TEST_CASE(a_body_turned_by_quarter_turns_in_water_moves_turned_to_the_bit) {
    const Environment environment = water();
    SoftBodyModel model = embody(hook(), environment, Parameters{});
    NativeEngine straight;
    straight.load(model, environment);
    SoftBodyModel turned_model = model;
    for (Vec2d &p : turned_model.positions) p = {-p.y, p.x};
    NativeEngine turned;
    turned.load(turned_model, environment);
    for (int t = 1; t <= 1000; ++t) {
        straight.step(swinging(model, t), 0);
        turned.step(swinging(model, t), 0);
    }
    const auto expected = straight.positions(), found = turned.positions();
    double moved = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
        BOOST_REQUIRE((found[i] == Vec2d{-expected[i].y, expected[i].x}));
        moved = std::max(moved, length(expected[i] - model.positions[i]));
    }
    BOOST_TEST(moved > 0.5);
}

BOOST_AUTO_TEST_CASE(energy_never_rises_without_actuation) {
    const auto model = embody(lattice(6, 3), empty_space(), Parameters{});
    const Environment environment = empty_space();
    SoftBodyModel stretched = model;
    for (Vec2d &p : stretched.positions) p = {p.x * 1.15, p.y * 0.95};
    NativeEngine engine;
    engine.load(stretched, environment);
    const auto energy = [&] {
        const auto x = engine.positions(), v = engine.velocities();
        double sum = 0;
        for (const Vec2d u : v) sum += 0.5 * squared_length(u);
        for (std::size_t i = 0; i < model.links.size(); ++i) {
            const double stretch = length(x[model.links[i].b] - x[model.links[i].a]) - model.rest_lengths[i];
            sum += 0.5 * model.parameters.spring_stiffness * stretch * stretch;
        }
        for (std::size_t i = 0; i < model.triangles.size(); ++i) {
            const auto [a, b, c] = model.triangles[i];
            const double loss = model.areas[i] - 0.5 * cross(x[b] - x[a], x[c] - x[a]);
            sum += 0.5 * model.parameters.pressure_stiffness / model.areas[i] * loss * loss;
        }
        return sum;
    };
    const double start = energy();
    double before = start;
    for (int t = 1; t <= 2000; ++t) {
        engine.step(model.rest_lengths, 0);
        if (t % 100 != 0) continue;
        BOOST_TEST(energy() <= before + 1e-3 * start);
        before = energy();
    }
    BOOST_TEST(before < 1e-2 * start);
}

BOOST_AUTO_TEST_CASE(without_drag_or_friction_muscles_move_nobody) {
    for (const bool on_land : {false, true}) {
        Environment environment = on_land ? land() : empty_space();
        environment.friction = 0;
        const auto model = embody(lattice(7, 3), environment, Parameters{});
        NativeEngine engine;
        engine.load(model, environment);
        for (int t = 1; t <= 4000; ++t) engine.step(swinging(model, t), 0);
        BOOST_TEST(std::abs(centre_of_mass(engine.positions()).x) < 1e-3);
    }
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

BOOST_AUTO_TEST_CASE(listed_contacts_are_those_of_a_search_over_all_pairs_to_the_bit) {
    // A hook whose ends are forced together; a skin larger than the body lists every pair.
    const auto model = embody(hook(), water(), Parameters{});
    SelfContact<float> listed, exhaustive(1000);
    listed.load(model), exhaustive.load(model);
    int hits = 0;
    for (int t = 0; t < 400; ++t) {
        std::vector<Vec2f> x;
        for (std::size_t i = 0; i < model.positions.size(); ++i) {
            const double squeeze = 0.004 * t, wave = 0.05 * std::sin(0.1 * t + static_cast<double>(i));
            const Vec2d p = model.positions[i];
            x.push_back({static_cast<float>(p.x * (1 - squeeze * 0.3) + wave),
                         static_cast<float>(p.y * (1 - squeeze * 0.6))});
        }
        std::vector<Vec2f> few(x.size()), all(x.size());
        listed.add_forces(x, few);
        exhaustive.add_forces(x, all);
        BOOST_REQUIRE((few == all));
        hits += std::any_of(all.begin(), all.end(), [](Vec2f f) { return f != Vec2f{}; });
    }
    BOOST_TEST(hits > 20);
}

BOOST_AUTO_TEST_CASE(contact_forces_are_internal) {
    const auto model = embody(hook(), water(), Parameters{});
    SelfContact<float> contact;
    contact.load(model);
    std::vector<Vec2f> x, forces(model.positions.size());
    for (const Vec2d p : model.positions)
        x.push_back({static_cast<float>(0.55 * p.x), static_cast<float>(0.08 * p.y)});
    contact.add_forces(x, forces);
    Vec2f sum;
    float size = 0;
    for (const Vec2f f : forces) sum += f, size += length(f);
    BOOST_TEST(size > 1);
    BOOST_TEST(length(sum) < 1e-5f * size);
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
