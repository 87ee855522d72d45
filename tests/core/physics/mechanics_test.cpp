// SPDX-License-Identifier: MIT
// Laws of mechanics on whole bodies: momentum, energy, symmetry and convergence (decisions 0006 to 0010).
#include "physics/forces.h"

#include "base/math.h"
#include "physics/embody.h"
#include "physics/laws/spring.h"
#include "physics/native/native_engine.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <functional>

using namespace planula;
using namespace planula::specimens;

namespace {

/// Elongations that let rest lengths swing by up to ±40 % with a phase along the nodes, as a function of time
/// in t.u.
std::vector<double> swinging(const SoftBodyModel &model, double time) {
    std::vector<double> elongations(model.positions.size());
    for (std::size_t i = 0; i < elongations.size(); ++i)
        elongations[i] = 0.2 * std::min(1.0, time / 2) * math::sin(6 * time + 0.7 * static_cast<double>(i));
    return elongations;
}

/// The same, while the outer links of a ring lengthen and the inner ones shorten: it closes.
std::vector<double> closing(const SoftBodyModel &model, double time) {
    std::vector<double> elongations = swinging(model, time);
    for (std::size_t i = 0; i < elongations.size(); ++i)
        elongations[i] += std::min(1.0, time / 4) * (i % 2 == 1 ? 0.125 : -0.125);
    return elongations;
}

/// The rest lengths of springs under these elongations.
std::vector<double> lengths_under(const std::vector<double> &elongations, const SoftBodyModel &model) {
    std::vector<double> lengths;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
        const auto [a, b] = model.links[i];
        lengths.push_back(actuated_length(model.rest_lengths[i], elongations[a], elongations[b]));
    }
    return lengths;
}

/// One step with these elongations.
Motion step_with(const std::vector<double> &elongations, Engine &engine) {
    engine.actuate(elongations, 1);
    return engine.step(0);
}

/// Whether any contact pushes.
bool is_touching(SelfContact<double> &contact, std::span<const Vec2d> x) {
    std::vector<Vec2d> push(x.size());
    contact.add_forces(x, push);
    return std::any_of(push.begin(), push.end(), [](Vec2d f) { return f != Vec2d{}; });
}

/// The same body, stretched at the start.
SoftBodyModel stretched(SoftBodyModel model, double along, double across) {
    for (Vec2d &p : model.positions) p = {p.x * along, p.y * across};
    return model;
}

double kinetic_energy(std::span<const Vec2d> v) {
    double sum = 0;
    for (const Vec2d u : v) sum += 0.5 * squared_length(u);
    return sum;
}

/// Stored in springs with these rest lengths and in the pressure of triangles.
double stored_energy(const SoftBodyModel &model, std::span<const double> rest_lengths,
                     std::span<const Vec2d> x) {
    const BodyParameters &p = model.body;
    double sum = 0;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
        const double stretch = length(x[model.links[i].b] - x[model.links[i].a]) - rest_lengths[i];
        sum += 0.5 * p.spring_stiffness * stretch * stretch;
    }
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        const auto [a, b, c] = model.triangles[i];
        const double loss = model.areas[i] - 0.5 * cross(x[b] - x[a], x[c] - x[a]);
        sum += 0.5 * p.pressure_stiffness / std::max(model.areas[i], p.area_floor) * loss * loss;
    }
    return sum;
}

double energy(const SoftBodyModel &model, const Engine &engine) {
    return kinetic_energy(engine.velocities()) + stored_energy(model, model.rest_lengths, engine.positions());
}

/// Σ F·v.
double power(std::span<const Vec2d> forces, std::span<const Vec2d> v) {
    double sum = 0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += dot(forces[i], v[i]);
    return sum;
}

/// Where the body is after `duration` t.u. with a time step of 0.01/`refinement`.
std::vector<Vec2d> after(double duration, SoftBodyModel model, const Environment &environment,
                         int refinement) {
    model.time_step /= refinement;
    NativeEngine engine;
    engine.load(model, environment);
    const int steps = static_cast<int>(std::lround(duration / model.time_step));
    for (int t = 1; t <= steps; ++t) step_with(swinging(model, t * model.time_step), engine);
    return engine.positions();
}

/// Root mean square of the distances between nodes of the same number.
double distance(const std::vector<Vec2d> &a, const std::vector<Vec2d> &b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += squared_length(a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Kinetic energy and height times gravity, which is 5, per node: on still ground without friction, muscles at rest, it
/// never rises above its start.
double energy_of_fall(const Engine &engine) {
    const auto x = engine.positions();
    return (kinetic_energy(engine.velocities()) / static_cast<double>(x.size())) + 5 * centre_of_mass(x).y;
}

/// What becomes of a body that slides on a ground without friction.
struct Slide {
    double start = 0, most = 0; // energy_of_fall()
    double behind = -1e9;       // the highest centre of mass beyond x = 5
    bool exploded = false;
    Vec2d end; // its centre of mass
};

Slide slid(std::vector<Vec2d> ground, double duration, double time_step) {
    const Environment environment{.gravity = 5, .has_ground = true, .ground = std::move(ground)};
    Parameters parameters;
    parameters.development.time_step = time_step;
    const auto model = soft_body(lattice(4, 3), environment, parameters);
    NativeEngine engine;
    engine.load(model, environment);
    Slide slide;
    slide.start = slide.most = energy_of_fall(engine);
    for (int t = 0; t < std::lround(duration / time_step); ++t) {
        slide.exploded |= engine.step(0).exploded;
        slide.end = centre_of_mass(engine.positions());
        slide.most = std::max(slide.most, energy_of_fall(engine));
        if (slide.end.x > 5) slide.behind = std::max(slide.behind, slide.end.y);
    }
    return slide;
}

/// A family of forces, and whether it acts between the body's own nodes.
struct Family {
    const char *name;
    bool internal;
    std::function<void(std::span<const Vec2d> x, std::span<const Vec2d> v, std::span<Vec2d> forces)> add;
};

} // namespace

BOOST_AUTO_TEST_CASE(each_family_of_inner_forces_has_no_resultant_and_no_torque) {
    // A ring squeezed until its ends overlap, in wild motion.
    const Environment environment = water();
    const auto model = soft_body(hook(), environment);
    std::vector<Vec2d> x, v;
    for (std::size_t i = 0; i < model.positions.size(); ++i) {
        const double phase = static_cast<double>(i);
        x.push_back({0.55 * model.positions[i].x, 0.08 * model.positions[i].y + 0.1 * math::sin(phase)});
        v.push_back({3 * math::sin(2 * phase), 2 * math::cos(3 * phase)});
    }
    Forces<double> law;
    law.load(model, environment);
    const std::vector<double> lengths = lengths_under(swinging(model, 5), model);
    const Family families[] = {
        {"springs", true, [&](auto p, auto u, auto f) { law.add_springs(lengths, p, u, f); }},
        {"pressure", true, [&](auto p, auto, auto f) { law.add_pressure(p, f); }},
        {"contact", true, [&](auto p, auto, auto f) { law.add_contact(p, f); }},
        {"drag", false, [&](auto p, auto u, auto f) { law.add_drag(p, u, f); }},
    };
    for (const auto &[name, internal, add] : families) {
        std::vector<Vec2d> forces(x.size());
        add(x, v, forces);
        Vec2d resultant;
        double torque = 0, scale = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            resultant += forces[i];
            torque += cross(x[i], forces[i]);
            scale += length(forces[i]);
        }
        BOOST_TEST(scale > 1, name);
        BOOST_TEST((length(resultant) < 1e-12 * scale) == internal, name);
        BOOST_TEST((std::abs(torque) < 1e-12 * scale) == internal, name);
    }
}

BOOST_AUTO_TEST_CASE(nothing_pushes_itself_in_empty_space) {
    // Momentum keeps to 1e-5 of its scale over 4000 steps with actuation on; the ring collides with
    // itself.
    const Environment environment = empty_space();
    for (const Body &body : {lattice(7, 4), hook()}) {
        const auto model = soft_body(body, environment);
        SelfContact<double> contact;
        contact.load(model);
        int contacts = 0;
        double extent = 0, scale = 0, linear = 0, angular = 0;
        for (const Vec2d p : model.positions) extent = std::max(extent, length(p));
        NativeEngine engine;
        engine.load(model, environment);
        for (int t = 1; t <= 4000; ++t) {
            const auto gait = body.cells() == hook().cells() ? closing : swinging;
            BOOST_REQUIRE(!step_with(gait(model, 0.01 * t), engine).exploded);
            const auto x = engine.positions(), v = engine.velocities();
            Vec2d momentum;
            double spin = 0, bustle = 0;
            for (std::size_t i = 0; i < x.size(); ++i)
                momentum += v[i], spin += cross(x[i], v[i]), bustle += length(v[i]);
            contacts += is_touching(contact, x);
            scale = std::max(scale, bustle);
            linear = std::max(linear, length(momentum));
            angular = std::max(angular, std::abs(spin));
        }
        BOOST_TEST_MESSAGE("momentum " << linear / scale << ", angular " << angular / (scale * extent));
        BOOST_TEST(scale > 10);
        BOOST_TEST((contacts > 20) == (body.cells() == hook().cells()));
        BOOST_TEST(linear < 1e-5 * scale);
        BOOST_TEST(angular < 1e-5 * scale * extent);
    }
}

BOOST_AUTO_TEST_CASE(without_drag_or_friction_muscles_move_nobody) {
    for (const bool on_land : {false, true}) {
        Environment environment = on_land ? land() : empty_space();
        environment.friction = 0;
        const auto model = soft_body(lattice(7, 3), environment);
        NativeEngine engine;
        engine.load(model, environment);
        for (int t = 1; t <= 4000; ++t) step_with(swinging(model, 0.01 * t), engine);
        BOOST_TEST(std::abs(centre_of_mass(engine.positions()).x) < 1e-3);
    }
}

BOOST_AUTO_TEST_CASE(undamped_energy_stays_near_its_start_and_nearer_with_half_the_step) {
    // Within 30 % over 4000 steps, and that error halves with dt.
    const Environment environment = empty_space();
    SoftBodyModel model = soft_body(lattice(6, 3), environment);
    model.body.spring_damping = 0;
    double errors[2];
    for (int half = 0; half < 2; ++half) {
        SoftBodyModel start = stretched(model, 1.1, 0.95);
        start.time_step /= 1 + half;
        NativeEngine engine;
        engine.load(start, environment);
        const double before = energy(model, engine);
        errors[half] = 0;
        for (int t = 1; t <= 4000 * (1 + half); ++t) {
            engine.step(0);
            errors[half] = std::max(errors[half], std::abs(energy(model, engine) - before) / before);
        }
    }
    BOOST_TEST_MESSAGE("energy errors " << errors[0] << ", " << errors[1]);
    BOOST_TEST(errors[0] < 0.3);
    BOOST_TEST(errors[0] > 1.6 * errors[1]);
    BOOST_TEST(errors[0] < 2.5 * errors[1]);
}

BOOST_AUTO_TEST_CASE(damped_energy_never_rises_without_actuation) {
    // Taken every 100 steps, by no more than 1e-3 of its start.
    for (const Environment &environment : {empty_space(), water()})
        for (const auto &[along, across] : {std::pair(1.15, 0.95), std::pair(0.9, 1.2)}) {
            const auto model = soft_body(lattice(6, 3), environment);
            const auto start = stretched(model, along, across);
            NativeEngine engine;
            engine.load(start, environment);
            const double first = energy(model, engine);
            double before = first, rise = 0;
            for (int t = 1; t <= 4000; ++t) {
                engine.step(0);
                if (t % 100 != 0) continue;
                const double present = energy(model, engine);
                rise = std::max(rise, present - before);
                before = present;
            }
            BOOST_TEST(rise < 1e-3 * first);
            BOOST_TEST(before < 1e-2 * first);
        }
}

BOOST_AUTO_TEST_CASE(still_ground_gives_no_energy_however_narrow_its_walls) {
    // Down a slope against a wall, and over its edge into a pit, at up to 12 cells/t.u.
    for (const double time_step : {0.01, 0.002, 1e-3})
        for (const double width : {1.0, 0.3, 0.1, 0.05, 0.01, 1e-3, 1e-5, 1e-7})
            for (const double height : {0.8, 1.2, 5.0, -0.8, -5.0}) {
                const Slide slide = slid({{-20, 10}, {10, -5}, {10 + width, height - 5}, {60, height - 5}},
                                         time_step < 0.002 ? 10 : 20, time_step);
                const auto what = [&](double value) {
                    return "wall " + std::to_string(width) + " wide, " + std::to_string(height) +
                           " high, dt " + std::to_string(time_step) + ": " + std::to_string(value);
                };
                BOOST_TEST(!slide.exploded, what(0));
                BOOST_TEST(slide.most < slide.start + 1e-3, what(slide.most - slide.start));
                BOOST_TEST(slide.end.y > std::min(-5.0, height - 5), what(slide.end.y));
            }
}

BOOST_AUTO_TEST_CASE(stairs_pits_and_fences_give_no_energy_either) {
    const std::vector<Vec2d> stairs{{-20, 10}, {-10, 5}, {-10 + 1e-4, 3}, {0, 3},  {1e-4, 1},  {8, 1},
                                    {8.1, 2},  {12, 2},  {12 + 1e-6, 0},  {20, 0}, {20.01, 9}, {40, 9}};
    const std::vector<Vec2d> pit{{-9 - 1e-3, 0.8}, {-9, 0}, {9, 0}, {9 + 1e-3, 0.8}};
    const std::vector<Vec2d> fence{{-20, 10}, {0, 0}, {5, 0}, {5 + 1e-9, 1}, {5 + 2e-9, 0}, {30, 0}};
    const std::vector<Vec2d> spikes{{-20, 10}, {0, 0}, {0.3, 1}, {0.6, 0}, {0.9, 1}, {1.2, 0}, {20, -5}};
    for (const auto &ground : {stairs, pit, fence, spikes})
        for (const double time_step : {0.015, 0.01, 0.002}) {
            const Slide slide = slid(ground, 20, time_step);
            BOOST_TEST(!slide.exploded);
            BOOST_TEST(slide.most < slide.start + 1e-3, slide.most - slide.start);
        }
}

BOOST_AUTO_TEST_CASE(a_life_is_the_same_at_any_height_and_place) {
    const auto moved = [](std::vector<Vec2d> ground, Vec2d place) {
        const Environment environment{
            .gravity = 5, .has_ground = true, .ground = std::move(ground), .friction = 0.8};
        auto model = soft_body(lattice(7, 3), environment);
        for (Vec2d &p : model.positions) p.x += place.x;
        NativeEngine engine;
        engine.load(model, environment);
        double fastest = 0;
        for (int t = 0; t < 1500; ++t) fastest = engine.step(1).fastest;
        BOOST_TEST(fastest < 0.01);
        for (int t = 1; t <= 500; ++t) step_with(swinging(model, 0.01 * t), engine);
        return centre_of_mass(engine.positions()) - place;
    };
    const Vec2d expected = moved({}, {});
    BOOST_TEST(length(expected) > 0.5);
    for (const Vec2d place : {Vec2d{0, 5}, {0, 1e4}, {0, -1e6}, {1e4, 0}, {-3e5, 1e5}})
        BOOST_TEST(length(moved({{place.x - 50, place.y}, {place.x + 50, place.y}}, place) - expected) <
                   1e-3);
    const Vec2d on_slope = moved({{-100, -20}, {100, 20}}, {});
    BOOST_TEST(length(moved({{-100, 1e4 - 20}, {100, 1e4 + 20}}, {0, 1e4}) - on_slope) < 1e-3);
}

BOOST_AUTO_TEST_CASE(the_ledger_of_work_dissipation_and_stored_energy_closes_to_first_order) {
    const Environment environment = water();
    const SoftBodyModel body = soft_body(lattice(7, 3), environment);
    double residuals[3], turnover = 0;
    for (int i = 0; i < 3; ++i) {
        SoftBodyModel model = body;
        const double dt = model.time_step /= 1 << i;
        NativeEngine engine;
        engine.load(model, environment);
        Forces<double> law;
        law.load(model, environment);
        double work = 0, heat = 0;
        std::vector<double> lengths = model.rest_lengths;
        const std::vector<Vec2d> still(model.positions.size());
        for (int t = 1; t <= 400 << i; ++t) {
            // Muscles work by changing rest lengths at fixed places.
            const auto x = engine.positions(), v = engine.velocities();
            const std::vector<double> elongations = swinging(model, t * dt);
            const std::vector<double> next = lengths_under(elongations, model);
            work += stored_energy(model, next, x) - stored_energy(model, lengths, x);
            lengths = next;
            // Water and the damping of springs take energy: the latter is what velocities add to springs.
            std::vector<Vec2d> moving(x.size()), resting(x.size());
            law.add_drag(x, v, moving);
            law.add_springs(lengths, x, v, moving);
            law.add_springs(lengths, x, still, resting);
            step_with(elongations, engine);
            heat += (power(resting, v) - power(moving, v)) * dt;
        }
        const double now =
            kinetic_energy(engine.velocities()) + stored_energy(model, lengths, engine.positions());
        residuals[i] = std::abs(work - heat - now);
        turnover = heat;
    }
    BOOST_TEST_MESSAGE("residuals " << residuals[0] << ", " << residuals[1] << ", " << residuals[2] << " of "
                                    << turnover);
    BOOST_TEST(turnover > 10);
    BOOST_TEST(residuals[2] < 0.05 * turnover);
    for (int i = 0; i < 2; ++i) {
        const double ratio = residuals[i] / residuals[i + 1];
        BOOST_TEST(ratio > 1.7);
        BOOST_TEST(ratio < 2.4);
    }
}

BOOST_AUTO_TEST_CASE(a_body_turned_by_quarter_turns_in_water_moves_turned_to_the_bit) {
    // Its ends collide on the way.
    const Environment environment = water();
    const SoftBodyModel model = soft_body(hook(), environment);
    const auto moved = [&](const SoftBodyModel &body, int &contacts) {
        NativeEngine engine;
        engine.load(body, environment);
        SelfContact<double> contact;
        contact.load(body);
        for (int t = 1; t <= 1000; ++t) {
            BOOST_REQUIRE(!step_with(closing(body, 0.01 * t), engine).exploded);
            contacts += is_touching(contact, engine.positions());
        }
        return engine.positions();
    };
    int contacts = 0;
    std::vector<Vec2d> expected = moved(model, contacts);
    BOOST_TEST(contacts > 20);
    SoftBodyModel turned = model;
    for (int quarter = 1; quarter < 4; ++quarter) {
        for (Vec2d &p : turned.positions) p = {-p.y, p.x};
        for (Vec2d &p : expected) p = {-p.y, p.x};
        BOOST_TEST((moved(turned, contacts) == expected), quarter << " quarter turns");
    }
}

BOOST_AUTO_TEST_CASE(a_mirrored_body_moves_mirrored) {
    // Within 1e-4 cells over 200 steps, without self-contact.
    const Environment environment = water();
    Body body = lattice(7, 3);
    for (std::size_t i = 0; i < body.positions.size(); ++i) // no two cells alike, no ties
        body.positions[i] +=
            Vec2d{math::sin(static_cast<double>(i)), math::cos(2.0 * static_cast<double>(i))} * 0.05;
    std::vector<Vec2d> reflection = body.positions;
    for (Vec2d &p : reflection) p.x = -p.x;
    SoftBodyModel straight = soft_body(make_body(body.positions, 1.5), environment);
    SoftBodyModel mirrored = soft_body(make_body(reflection, 1.5), environment);
    BOOST_TEST((straight.links == mirrored.links));
    straight.body.contact_stiffness = mirrored.body.contact_stiffness = 0;
    std::vector<Vec2d> expected = after(2, straight, environment, 1);
    BOOST_TEST(distance(expected, straight.positions) > 0.05);
    for (Vec2d &p : expected) p.x = -p.x;
    const auto found = after(2, mirrored, environment, 1);
    double apart = 0;
    for (std::size_t i = 0; i < found.size(); ++i) apart = std::max(apart, length(found[i] - expected[i]));
    BOOST_TEST_MESSAGE("mirrored bodies differ by " << apart);
    BOOST_TEST(apart < 1e-4);
}

BOOST_AUTO_TEST_CASE(half_the_step_brings_the_trajectory_nearer_at_first_order) {
    for (const Environment &environment : {empty_space(), water()}) {
        auto model = stretched(soft_body(lattice(6, 3), environment), 1.05, 0.97);
        const auto whole = after(1, model, environment, 1), half = after(1, model, environment, 2),
                   quarter = after(1, model, environment, 4);
        const double order = std::log2(distance(whole, half) / distance(half, quarter));
        BOOST_TEST_MESSAGE("order " << order << ", " << distance(whole, half));
        BOOST_TEST(order > 0.8);
        BOOST_TEST(order < 1.3);
    }
}
