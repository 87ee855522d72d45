// SPDX-License-Identifier: MIT
// Obstacles, ceilings, friction patches and loose objects, in all engines (decision 0024).
#include "physics/walls.h"

#include "base/random.h"
#include "physics/embody.h"
#include "physics/object.h"
#include "physics/room.h"
#include "support/lockstep.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <string>

using namespace planula;
using namespace planula::specimens;

namespace {

std::vector<Vec2d> box(double left, double bottom, double width, double height) {
    return {{left, bottom}, {left + width, bottom}, {left + width, bottom + height}, {left, bottom + height}};
}

Environment with(Environment environment, std::vector<std::vector<Vec2d>> obstacles) {
    for (auto &points : obstacles) environment.obstacles.push_back({std::move(points)});
    return environment;
}

/// A body that starts elsewhere.
SoftBodyModel at(Vec2d place, SoftBodyModel model) {
    for (Vec2d &position : model.positions) position += place;
    return model;
}

/// A body that starts this far to the side and this much above the ground there.
SoftBodyModel above_ground(Vec2d place, SoftBodyModel model, const Environment &environment) {
    model = at({place.x, 0}, std::move(model));
    double least = 1e9;
    for (const Vec2d p : model.positions) least = std::min(least, p.y - ground_height(environment, p.x));
    return at({0, place.y - least}, std::move(model));
}

SoftBodyModel model_of(const Body &body, const Environment &environment, double time_step) {
    Parameters parameters;
    parameters.development.time_step = time_step;
    return soft_body(body, environment, parameters);
}

/// Whether a node is inside an obstacle.
bool has_crossed(std::span<const Vec2d> nodes, const Environment &environment) {
    for (const Vec2d node : nodes)
        for (const Obstacle &obstacle : environment.obstacles)
            if (is_inside(node, obstacle.points)) return true;
    return false;
}

/// Whether two nodes of a spring are on different sides of a wall.
bool is_cut(const SoftBodyModel &model, std::span<const Vec2d> x, const Environment &environment) {
    const Walls<double> walls(environment, {});
    for (const auto [a, b] : model.links)
        for (const Wall<double> &wall : walls.all())
            if (wall.pierces && crosses(wall, x[a], x[b])) return true;
    return false;
}

/// A body that falls with this gravity for a time.
struct Fall {
    double start = 0, most = 0; // energy per node, of motion and height: as much as springs hold is missing
    bool exploded = false, crossed = false;
    int cut = 0; // steps at which a wall crosses a spring
    std::vector<Vec2d> positions, velocities;
};

Fall fall_of(std::string_view name, const SoftBodyModel &model, const Environment &environment,
             double duration) {
    const auto engine = loaded(name, model, environment);
    Fall fall;
    const auto energy = [&] {
        const auto x = engine->positions();
        return kinetic_energy(engine->velocities()) / static_cast<double>(x.size()) +
               environment.gravity * centre_of_mass(x).y;
    };
    fall.start = fall.most = energy();
    for (int t = 0; t < std::lround(duration / model.time_step); ++t) {
        fall.exploded |= engine->step(0).exploded;
        fall.most = std::max(fall.most, energy());
        if (t % 10 == 0) {
            fall.crossed |= has_crossed(engine->positions(), environment);
            fall.cut += is_cut(model, engine->positions(), environment);
        }
    }
    fall.positions = engine->positions(), fall.velocities = engine->velocities();
    return fall;
}

bool fits(const Body &body, const Environment &environment) {
    const auto model = soft_body(body, environment);
    return has_room(model, model.positions, environment);
}

double lowest(std::span<const Vec2d> nodes) {
    double least = nodes.front().y;
    for (const Vec2d node : nodes) least = std::min(least, node.y);
    return least;
}

} // namespace

BOOST_AUTO_TEST_CASE(walls_give_no_energy_and_hold_however_thin_they_are) {
    // From 8 cells onto the edge of an upright wall, a board and a box.
    for (const std::string_view name : {"native", "reference"})
        for (const double time_step : {0.015, 0.004})
            for (const double width : {1.0, 0.1, 1e-3, 1e-7})
                for (const int shape : {0, 1, 2}) {
                    Environment environment{.gravity = 5, .has_ground = true};
                    const auto points = shape == 0   ? box(0.3, 0, width, 4)
                                        : shape == 1 ? box(-3, 3, 3.2, width)
                                                     : box(-0.6, 2, 1.2 + width, 1.2);
                    environment.obstacles.push_back({points});
                    const auto model = at({0, 8}, model_of(lattice(4, 3), environment, time_step));
                    const Fall fall = fall_of(name, model, environment, 12);
                    const std::string what = std::string(name) + ", dt " + std::to_string(time_step) +
                                             ", width " + std::to_string(width) + ", shape " +
                                             std::to_string(shape);
                    BOOST_TEST_MESSAGE(what << ": " << fall.most - fall.start << ", cut " << fall.cut);
                    BOOST_TEST(!fall.exploded, what);
                    BOOST_TEST(fall.most < fall.start + 1e-3, what << ": " << fall.most - fall.start);
                    BOOST_TEST(!fall.crossed, what);
                    BOOST_TEST(lowest(fall.positions) > -1e-6, what);
                }
}

BOOST_AUTO_TEST_CASE(a_body_that_falls_into_an_opening_is_squeezed_and_gains_no_energy) {
    for (const std::string_view name : {"native", "reference"})
        for (const double opening : {3.5, 2.0, 1.0}) {
            const Environment environment =
                with({.gravity = 5, .has_ground = true, .ground = {{-20, 12}, {2, 0}, {60, 0}}},
                     {{{4, opening}, {40, opening}, {40, 9}, {4.2, 9}}});
            const auto model =
                above_ground({-12, 1}, model_of(lattice(4, 3), environment, 0.01), environment);
            const Fall fall = fall_of(name, model, environment, 15);
            BOOST_TEST_MESSAGE(name << ", " << opening << ": to " << centre_of_mass(fall.positions)
                                    << ", cut " << fall.cut);
            BOOST_TEST(!fall.exploded, name);
            BOOST_TEST(fall.most < fall.start + 1e-3, name << ": " << fall.most - fall.start);
            BOOST_TEST(!fall.crossed, name);
        }
}

BOOST_AUTO_TEST_CASE(a_body_stays_between_ground_and_ceiling) {
    for (const std::string_view name : {"native", "reference", "bullet"}) {
        Environment environment{.gravity = 5, .has_ground = true, .ground = {{-20, 10}, {0, 0}, {30, 0}}};
        environment.ceiling = {{-20, 15}, {0, 5}, {3, 2.2}, {5, 5}, {30, 3}};
        const auto model = above_ground({-10, 0.2}, model_of(lattice(4, 3), environment, 0.01), environment);
        const Fall fall = fall_of(name, model, environment, 10);
        BOOST_TEST(!fall.exploded, name);
        BOOST_TEST(fall.most < fall.start + (name == "bullet" ? 1 : 1e-3), name << fall.most - fall.start);
        for (const Vec2d node : fall.positions) {
            BOOST_TEST(node.y < height_of(environment.ceiling, node.x) + 1e-6, name);
            BOOST_TEST(node.y > ground_height(environment, node.x) - (name == "bullet" ? 0.02 : 1e-6), name);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_corner_between_two_nodes_carries_the_body) {
    // A wall thinner than the body's cells are apart: it would enter between two of them.
    for (const std::string_view name : {"native", "reference", "bullet"})
        for (const double width : {0.2, 1e-3}) {
            const Environment environment = with(land(), {box(0.5 - width / 2, -1, width, 4)});
            const auto model = at({0, 5}, model_of(lattice(6, 4), environment, 0.015));
            const auto engine = loaded(name, model, environment);
            double deepest = 0;
            for (int t = 0; t < 400; ++t) {
                engine->step(1);
                const auto x = engine->positions();
                for (const OutlineLink &link : model.outline)
                    if (cross(x[link.b] - x[link.a], Vec2d{0.5, 3} - x[link.a]) > 0) {
                        const Vec2d foot = foot_on_segment(Vec2d{0.5, 3}, x[link.a], x[link.b]).point;
                        if (std::abs(foot.x - 0.5) < 0.3)
                            deepest = std::max(deepest, std::min(3 - foot.y, 1.0));
                    }
            }
            BOOST_TEST_MESSAGE(name << ", " << width << ": deepest " << deepest);
            BOOST_TEST(deepest > 0, name);
            BOOST_TEST(deepest < 0.3, name << ": " << deepest);
        }
}

BOOST_AUTO_TEST_CASE(each_native_step_on_walls_is_that_of_the_reference_engine) {
    Environment room = with(land(), {box(3, 0, 1, 0.6), {{-6, 0.4}, {-4, 0.2}, {-3, 1.4}, {-5, 0.9}}});
    room.ceiling = {{-9, 4}, {-2, 4.5}, {0, 6}, {4, 4}};
    room.friction_patches = {{-2, 0.5, 0.1}, {2, 9, 2}};
    room.obstacles[0].friction = 0.2;
    Environment pool = with(water(), {box(4, -5, 0.01, 10), box(-5, -5, 1, 10), box(-5, -4, 10, 1)});
    pool.flow = {0.5, -0.3};
    Environment pushing = land();
    pushing.object = make_object({4, 2}, 1.5);
    for (const auto &[name, environment] : {std::pair("room", room), {"pool", pool}, {"pushing", pushing}}) {
        Lockstep lockstep;
        for (const Body &body : {lattice(5, 3), lattice(7, 2), hook(), two_arms(1), u_body(1)}) {
            const auto model = soft_body(body, environment);
            lockstep.load(model, environment);
            for (int t = 0; t < 1200; ++t) {
                if (t >= 50 && t % 10 == 0) {
                    auto extensions = closing(model, 0.01 * (t - 50));
                    std::fill(extensions.begin() + model.cells(), extensions.end(), 0.0);
                    lockstep.actuate(extensions, 10);
                }
                if (lockstep.step(t < 50 ? 1 : 0).exploded) break;
            }
        }
        BOOST_TEST_MESSAGE(name << ": " << lockstep.steps << " steps, off by " << lockstep.position_error
                                << " cells and " << lockstep.velocity_error << " cells/t.u.");
        BOOST_TEST(lockstep.exploded_alike, name);
        BOOST_TEST(lockstep.position_error < 2e-5, name);
        BOOST_TEST(lockstep.velocity_error < 2e-3, name);
    }
}

BOOST_AUTO_TEST_CASE(bullet_moves_on_walls_as_the_reference_engine_does) {
    Environment room = with(land(), {box(3.2, 0, 1, 1.5)});
    room.friction_patches = {{-9, 0, 0.1}};
    room.ceiling = {{-9, 6}, {9, 6}};
    for (const Body &body : {lattice(5, 3), lattice(3, 3)}) {
        const auto model = soft_body(body, room);
        const auto reference = loaded("reference", model, room), bullet = loaded("bullet", model, room);
        for (int t = 1; t <= 200; ++t)
            for (Engine *engine : {reference.get(), bullet.get()})
                step_with(swinging(model, 0.01 * t), *engine);
        const double apart = farthest_apart(reference->positions(), bullet->positions());
        BOOST_TEST_MESSAGE(apart);
        BOOST_TEST(farthest_apart(model.positions, reference->positions()) > 0.3);
        BOOST_TEST(apart < 0.1);
    }
}

BOOST_AUTO_TEST_CASE(a_body_slides_on_each_patch_as_far_as_friction_lets_it) {
    // Down a slope without friction, then on level ground: v² falls by 2 μ g s.
    Environment environment{.gravity = 5, .has_ground = true, .ground = {{-12, 3}, {-2, 0}, {500, 0}}};
    environment.friction_patches = {{3, 5, 0.4}, {5, 400, 0.8}};
    for (const std::string_view name : {"native", "reference", "bullet"})
        for (const double from : {-4.0, -9.0}) {
            const auto model =
                above_ground({from, 1e-3}, model_of(lattice(1, 1), environment, 0.002), environment);
            const auto engine = loaded(name, model, environment);
            double speed = 0; // where the first patch begins
            for (int t = 0; t < 8000; ++t) {
                engine->step(0);
                if (engine->positions()[0].x < 3) speed = engine->velocities()[0].x;
            }
            const double left = speed * speed - 2 * 0.4 * 5 * 2;
            const double expected = left > 0 ? 5 + left / (2 * 0.8 * 5) : 3 + speed * speed / (2 * 0.4 * 5);
            const double stopped = engine->positions()[0].x;
            BOOST_TEST_MESSAGE(name << ": " << speed << " stops at " << stopped << ", by hand " << expected);
            BOOST_TEST(speed > 1, name);
            BOOST_TEST((stopped > 5) == (from < -5), name);
            BOOST_TEST(std::abs(stopped - expected) < (name == "bullet" ? 0.15 : 0.01),
                       name << ": " << stopped << ", not " << expected);
        }
}

BOOST_AUTO_TEST_CASE(a_push_keeps_the_momentum_of_both) {
    // In empty space: a swinging body beside a loose object, which it strikes.
    for (const std::string_view name : {"native", "reference", "bullet"}) {
        Environment space;
        space.object = make_object({4.6, 0.3}, 1.2);
        const auto model = soft_body(lattice(5, 3), space);
        BOOST_TEST(has_room(model, model.positions, space));
        const auto engine = loaded(name, model, space);
        double touched = 0;
        for (int t = 0; t < 1500; ++t) {
            auto extensions = swinging(model, 0.01 * t);
            for (int i = 0; i < model.cells(); ++i) extensions[i] += std::min(0.25, 0.002 * t);
            std::fill(extensions.begin() + model.cells(), extensions.end(), 0.0);
            step_with(extensions, *engine);
            touched += is_touching(model, engine->positions());
        }
        const auto v = engine->velocities();
        const Vec2d of_object = centre_of_mass(std::span<const Vec2d>(v).last(model.object_nodes));
        BOOST_TEST_MESSAGE(name << ": touched " << touched << ", object moves at " << of_object << ", all at "
                                << centre_of_mass(v));
        BOOST_TEST(touched > 0, name);
        BOOST_TEST(length(of_object) > 0.01, name);
        BOOST_TEST(length(centre_of_mass(v)) < 1e-5, name);
    }
}

BOOST_AUTO_TEST_CASE(a_body_without_room_is_told) {
    const Environment wall = with(land(), {box(1, 0, 1, 3)});
    BOOST_TEST(!fits(lattice(8, 3), wall));
    BOOST_TEST(fits(lattice(2, 2), wall));
    Environment low = land();
    low.ceiling = {{-9, 2}, {9, 2}};
    BOOST_TEST(fits(lattice(4, 2), low));
    BOOST_TEST(!fits(lattice(4, 4), low));
    Environment full = land();
    full.object = make_object({3, 1}, 1);
    BOOST_TEST(fits(lattice(2, 2), full));
    BOOST_TEST(!fits(lattice(6, 2), full));
    BOOST_TEST(!fits(lattice(20, 9), full));
}

BOOST_AUTO_TEST_CASE(many_points_cost_each_node_a_few_walls) {
    Environment environment = land();
    for (int i = 0; i < 100; ++i) {
        Obstacle round;
        for (int j = 0; j < 50; ++j)
            round.points.push_back(
                {10.0 * i + 5 + 2 * math::cos(0.1256637 * j), 3 + 2 * math::sin(0.1256637 * j)});
        environment.obstacles.push_back(round);
    }
    const Walls<double> walls(environment, {});
    long seen = 0, places = 0;
    for (double x = 0; x < 1000; x += 0.37, ++places)
        each_wall_near(walls.view(), Vec2d{x, 1.5}, Vec2d{x + 0.05, 1.55}, [&](int) { ++seen; });
    BOOST_TEST(walls.all().size() > 5000);
    BOOST_TEST(static_cast<double>(seen) / static_cast<double>(places) < 20);
}

BOOST_AUTO_TEST_CASE(the_grid_misses_no_wall) {
    Stream stream(7, 0, 0, Purpose::initial_weights);
    Environment environment = with(land(), {});
    for (int i = 0; i < 30; ++i) {
        const Vec2d middle{100 * stream.triangular(), 40 + 30 * stream.triangular()};
        environment.obstacles.push_back(
            {{middle, middle + Vec2d{20 * stream.uniform() + 1, 5 * stream.triangular()},
              middle + Vec2d{0.5, 9}}});
    }
    const Walls<float> walls(environment, {3, 1});
    for (int i = 0; i < 20000; ++i) {
        const Vec2f start{static_cast<float>(120 * stream.triangular()),
                          static_cast<float>(90 * stream.triangular() + 40)};
        const Vec2f way{static_cast<float>(stream.triangular()), static_cast<float>(stream.triangular())};
        float first = 2;
        for (const Wall<float> &wall : walls.all())
            first = std::min(first, meeting_with(wall, start, way).time);
        const float found = first_met(walls.view(), start, way).time;
        BOOST_REQUIRE((found == first || (first > 1 && found > 1)));
    }
}
