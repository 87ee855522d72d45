// SPDX-License-Identifier: MIT
// Laws of mechanics on whole bodies, in every engine: momentum, energy and convergence (decisions 0006 to 0010).
#include "physics/engine.h"

#include "physics/embody.h"
#include "physics/energy.h"
#include "support/motion.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace planula;
using namespace planula::specimens;

namespace {

/// The same body, stretched at the start.
SoftBodyModel stretched(SoftBodyModel model, double along, double across) {
    for (Vec2d &p : model.positions) p = {p.x * along, p.y * across};
    return model;
}

double energy(const SoftBodyModel &model, const Engine &engine) {
    return kinetic_energy(engine.velocities()) +
           elastic_energy(model, model.rest_lengths, engine.positions());
}

/// Σ F·v.
double power(std::span<const Vec2d> forces, std::span<const Vec2d> v) {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += dot(forces[i], v[i]);
    return sum;
}

/// The largest momentum and angular momentum that a body had, and their scales.
struct Momentum {
    double linear = 0, angular = 0;
    double scale = 0, extent = 0; // Σ |v|; how far a node is from the origin
    int touching = 0;             // steps at which the body touched itself

    void measure(std::span<const Vec2d> x, std::span<const Vec2d> v) {
        Vec2d momentum;
        double spin = 0, sum = 0;
        for (std::size_t i = 0; i < x.size(); ++i)
            momentum += v[i], spin += cross(x[i], v[i]), sum += length(v[i]);
        scale = std::max(scale, sum);
        linear = std::max(linear, length(momentum));
        angular = std::max(angular, std::abs(spin));
    }
};

/// Of a body that swings for 4000 steps in empty space.
Momentum momentum_of(std::string_view name, const Body &body, bool closes) {
    const Environment environment = empty_space();
    const auto model = soft_body(body, environment);
    const auto engine = loaded(name, model, environment);
    Momentum result;
    for (const Vec2d p : model.positions) result.extent = std::max(result.extent, length(p));
    for (int t = 1; t <= 4000; ++t) {
        const double time = 0.01 * t;
        BOOST_REQUIRE(!step_with(closes ? closing(model, time) : swinging(model, time), *engine).exploded);
        result.measure(engine->positions(), engine->velocities());
        result.touching += is_touching(model, engine->positions());
    }
    return result;
}

/// What muscles put into a body in water, what water and springs take, and what it has at the end.
struct Ledger {
    double work = 0, heat = 0, stored = 0;
    double residual() const { return std::abs(work - heat - stored); }
};

/// Over 4 t.u., at the time step of the model.
Ledger ledger_of(std::string_view name, const SoftBodyModel &model) {
    const Environment environment = water();
    const double dt = model.time_step;
    const auto engine = loaded(name, model, environment);
    Ledger ledger;
    std::vector<double> lengths = model.rest_lengths;
    for (int t = 1; t <= std::lround(4 / dt); ++t) {
        // Muscles work by changing rest lengths at fixed places.
        const reference::Nodes nodes{engine->positions(), engine->velocities()};
        const std::vector<double> extensions = swinging(model, t * dt);
        const std::vector<double> next = lengths_under(extensions, model);
        ledger.work +=
            elastic_energy(model, next, nodes.positions) - elastic_energy(model, lengths, nodes.positions);
        lengths = next;
        // Water and the damping of springs take energy: the latter is what velocities add to springs.
        std::vector<Vec2d> moving(nodes.positions.size()), resting(moving.size());
        reference::add_drag(model, environment, nodes, moving);
        reference::add_springs(model, lengths, nodes, moving);
        reference::add_springs(model, lengths, {nodes.positions, std::vector<Vec2d>(moving.size())}, resting);
        step_with(extensions, *engine);
        ledger.heat += (power(resting, nodes.velocities) - power(moving, nodes.velocities)) * dt;
    }
    ledger.stored =
        kinetic_energy(engine->velocities()) + elastic_energy(model, lengths, engine->positions());
    return ledger;
}

/// Where the body is after 1 t.u. with a time step of 0.01/`refinement`.
std::vector<Vec2d> after(std::string_view name, SoftBodyModel model, const Environment &environment,
                         int refinement) {
    const double dt = model.time_step /= refinement;
    const auto engine = loaded(name, model, environment);
    for (int t = 1; t <= 100 * refinement; ++t) step_with(swinging(model, t * dt), *engine);
    return engine->positions();
}

/// Root mean square of the distances between nodes of the same number.
double distance(const std::vector<Vec2d> &a, const std::vector<Vec2d> &b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += squared_length(a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

} // namespace

BOOST_AUTO_TEST_CASE(momentum_is_kept_in_empty_space) {
    // To rounding, over 4000 steps with actuation on; the ring collides with itself.
    for (const std::string_view name : engine_names()) {
        const double rounding = name == "native" ? 1e-5 : 1e-12;
        for (const bool closes : {false, true}) {
            const Momentum m = momentum_of(name, closes ? hook() : lattice(7, 4), closes);
            BOOST_TEST_MESSAGE(name << ": momentum " << m.linear / m.scale << ", angular "
                                    << m.angular / (m.scale * m.extent));
            BOOST_TEST(m.scale > 10, name);
            BOOST_TEST((m.touching > 20) == closes, name);
            BOOST_TEST(m.linear < rounding * m.scale, name);
            BOOST_TEST(m.angular < rounding * m.scale * m.extent, name);
        }
    }
}

BOOST_AUTO_TEST_CASE(without_drag_or_friction_muscles_do_not_displace_a_body) {
    for (const std::string_view name : engine_names())
        for (const bool on_land : {false, true}) {
            Environment environment = on_land ? land() : empty_space();
            environment.friction = 0;
            const auto model = soft_body(lattice(7, 3), environment);
            const auto engine = loaded(name, model, environment);
            for (int t = 1; t <= 4000; ++t) step_with(swinging(model, 0.01 * t), *engine);
            const double x = std::abs(centre_of_mass(engine->positions()).x);
            BOOST_TEST_MESSAGE(name << ": " << x);
            BOOST_TEST(x < (name == "native" ? 1e-3 : 1e-9), name);
        }
}

BOOST_AUTO_TEST_CASE(undamped_energy_stays_near_its_start_and_nearer_with_half_the_step) {
    // Within 30 % over 4000 steps, and that error halves with dt.
    const Environment environment = empty_space();
    SoftBodyModel model = stretched(soft_body(lattice(6, 3), environment), 1.1, 0.95);
    model.body.spring_damping = 0;
    for (const std::string_view name : engine_names()) {
        double errors[2] = {};
        for (int half = 0; half < 2; ++half) {
            SoftBodyModel start = model;
            start.time_step /= 1 + half;
            const auto engine = loaded(name, start, environment);
            const double before = energy(start, *engine);
            for (int t = 1; t <= 4000 * (1 + half); ++t) {
                engine->step(0);
                errors[half] = std::max(errors[half], std::abs(energy(start, *engine) - before) / before);
            }
        }
        BOOST_TEST_MESSAGE(name << ": energy errors " << errors[0] << ", " << errors[1]);
        BOOST_TEST(errors[0] < 0.3, name);
        BOOST_TEST(errors[0] > 1.6 * errors[1], name);
        BOOST_TEST(errors[0] < 2.5 * errors[1], name);
    }
}

BOOST_AUTO_TEST_CASE(damped_energy_never_rises_without_actuation) {
    // Taken every 100 steps, by no more than 1e-3 of its start.
    for (const std::string_view name : engine_names())
        for (const Environment &environment : {empty_space(), water()})
            for (const auto &[along, across] : {std::pair(1.15, 0.95), std::pair(0.9, 1.2)}) {
                const auto model = stretched(soft_body(lattice(6, 3), environment), along, across);
                const auto engine = loaded(name, model, environment);
                const double first = energy(model, *engine);
                double before = first, rise = 0;
                for (int t = 1; t <= 4000; ++t) {
                    engine->step(0);
                    if (t % 100 != 0) continue;
                    const double present = energy(model, *engine);
                    rise = std::max(rise, present - before);
                    before = present;
                }
                BOOST_TEST(rise < 1e-3 * first, name);
                BOOST_TEST(before < 1e-2 * first, name);
            }
}

BOOST_AUTO_TEST_CASE(work_dissipation_and_stored_energy_balance_to_first_order) {
    const SoftBodyModel model = soft_body(lattice(7, 3), water());
    for (const std::string_view name : engine_names()) {
        Ledger ledgers[3];
        for (int i = 0; i < 3; ++i) {
            SoftBodyModel refined = model;
            refined.time_step /= 1 << i;
            ledgers[i] = ledger_of(name, refined);
        }
        BOOST_TEST_MESSAGE(name << ": residuals " << ledgers[0].residual() << ", " << ledgers[1].residual()
                                << ", " << ledgers[2].residual() << " of " << ledgers[2].heat);
        BOOST_TEST(ledgers[2].heat > 10, name);
        BOOST_TEST(ledgers[2].residual() < 0.05 * ledgers[2].heat, name);
        for (int i = 0; i < 2; ++i) {
            const double ratio = ledgers[i].residual() / ledgers[i + 1].residual();
            BOOST_TEST(ratio > 1.7, name);
            BOOST_TEST(ratio < 2.4, name);
        }
    }
}

BOOST_AUTO_TEST_CASE(half_the_step_brings_the_trajectory_nearer_at_first_order) {
    for (const std::string_view name : engine_names())
        for (const Environment &environment : {empty_space(), water()}) {
            const auto model = stretched(soft_body(lattice(6, 3), environment), 1.05, 0.97);
            const auto whole = after(name, model, environment, 1), half = after(name, model, environment, 2),
                       quarter = after(name, model, environment, 4);
            const double order = std::log2(distance(whole, half) / distance(half, quarter));
            BOOST_TEST_MESSAGE(name << ": order " << order << ", " << distance(whole, half));
            BOOST_TEST(order > 0.8, name);
            BOOST_TEST(order < 1.3, name);
        }
}
