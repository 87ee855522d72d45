// SPDX-License-Identifier: MIT
// Each force law against numbers worked out by hand.
#include "physics/laws/contact.h"
#include "physics/laws/drag.h"
#include "physics/laws/ground.h"
#include "physics/laws/pressure.h"
#include "physics/laws/spring.h"

#include "support/print.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

const auto near = boost::test_tools::tolerance(1e-12);

/// What a counter-clockwise triangle does to its three corners.
struct CornerForces {
    Vec2d a, b, c;
};

CornerForces corner_forces(Vec2d a, Vec2d b, Vec2d c, const Pressure<double> &pressure) {
    return {pressure_force(b - a, c - a, pressure), pressure_force(c - b, a - b, pressure),
            pressure_force(a - c, b - c, pressure)};
}

} // namespace

BOOST_AUTO_TEST_CASE(a_spring_pulls_by_hooke_and_damps_along_itself) {
    // l = 5 along (0.6, 0.8), L = 4, dl/dt = 1·0.6 + 2·0.8 = 2.2: tension 400 · 1 + 8 · 2.2 = 417.6.
    const Vec2d force = spring_force<double>(spring_to<double>({3, 4}, {1, 2}), 400, 400 * 4, 8);
    BOOST_TEST(force.x == 417.6 * 0.6, near);
    BOOST_TEST(force.y == 417.6 * 0.8, near);
    const auto across = spring_to<double>({1, 0}, {0, 5}); // motion across is free
    BOOST_TEST((spring_force<double>(across, 400, 400 * 1, 8) == Vec2d{}));
}

BOOST_AUTO_TEST_CASE(pressure_pushes_a_compressed_triangle_open) {
    // A = 1/2, A0 = 0.6, stiffness 2000/0.6: p = 333.33…; ∂A/∂b = ½ (c − a) turned right = (0.5, 0).
    const auto forces = corner_forces({0, 0}, {1, 0}, {0, 1}, pressure_of<double>(0.6, 2000, 0.2));
    const double p = 2000.0 / 6;
    BOOST_TEST(forces.b.x == 0.5 * p, near);
    BOOST_TEST(forces.b.y == 0);
    BOOST_TEST(forces.c.y == 0.5 * p, near);
    BOOST_TEST(forces.a.x == -0.5 * p, near);
    BOOST_TEST(forces.a.y == -0.5 * p, near);
}

BOOST_AUTO_TEST_CASE(pressure_is_minus_the_gradient_of_its_energy) {
    const Vec2d a{0.1, -0.2}, b{1.1, 0.3}, c{0.2, 0.9};
    const double A0 = 0.4, k = 1500, h = 1e-6;
    const auto energy = [&](Vec2d corner) {
        const double loss = A0 - 0.5 * cross(b - corner, c - corner);
        return 0.5 * k * loss * loss;
    };
    const auto forces = corner_forces(a, b, c, pressure_of<double>(A0, k * A0, 0.2));
    const auto loose = boost::test_tools::tolerance(1e-6);
    BOOST_TEST(forces.a.x == -(energy({a.x + h, a.y}) - energy({a.x - h, a.y})) / (2 * h), loose);
    BOOST_TEST(forces.a.y == -(energy({a.x, a.y + h}) - energy({a.x, a.y - h})) / (2 * h), loose);
}

BOOST_AUTO_TEST_CASE(small_triangles_get_the_stiffness_of_the_floor) {
    const auto small = pressure_of<double>(0.1, 2000, 0.2), floor = pressure_of<double>(0.2, 2000, 0.2);
    BOOST_TEST(small.slope == floor.slope);
    BOOST_TEST(small.twice_area == floor.twice_area / 2, near);
}

BOOST_AUTO_TEST_CASE(an_inverted_triangle_is_pushed_back) {
    // c lies below the edge a → b: area −1/2.
    const auto forces = corner_forces({0, 0}, {1, 0}, {0, -1}, pressure_of<double>(0.5, 2000, 0.2));
    BOOST_TEST(forces.c.y > 0);
}

BOOST_AUTO_TEST_CASE(drag_is_quadratic_and_weaker_along_the_edge) {
    // ℓ = 2 along x, v = (3, −0.5): F_T = −0.1 · 2 · 9, F_N = +1 · 2 · 0.25.
    const Vec2d force = drag_force<double>({2, 0}, {3, -0.5}, 1.0, 0.1);
    BOOST_TEST(force.x == -1.8, near);
    BOOST_TEST(force.y == 0.5, near);
    BOOST_TEST((drag_force<double>({-2, 0}, {3, -0.5}, 1.0, 0.1) == force)); // either way round
}

BOOST_AUTO_TEST_CASE(the_foot_on_a_segment_is_clamped_to_its_ends) {
    BOOST_TEST(foot_on_segment<double>({0.25, 3}, {0, 0}, {1, 0}).t == 0.25);
    BOOST_TEST((foot_on_segment<double>({-2, 1}, {0, 0}, {1, 0}).point == Vec2d{0, 0}));
    BOOST_TEST((foot_on_segment<double>({5, 1}, {0, 0}, {1, 0}).point == Vec2d{1, 0}));
}

BOOST_AUTO_TEST_CASE(contact_pushes_apart_within_its_reach) {
    const auto push = [](double x, double y) { return contact_force<double>({x, y}, 1600, 0.35); };
    BOOST_TEST(push(0, 0.1).y == 400, near); // 1600 (0.35 − 0.1), away from the link
    BOOST_TEST(push(0, -0.1).y == -400, near);
    BOOST_TEST(push(0.06, 0.08).x == 240, near);
    BOOST_TEST((push(0, 0.35) == Vec2d{}));
    BOOST_TEST((push(0, 0) == Vec2d{}));
}

BOOST_AUTO_TEST_CASE(the_ground_stops_the_normal_speed_and_friction_is_its_share_of_the_impulse) {
    const GroundPlane<double> level{{0, 0}, {0, 1}};
    // y + v_y dt = 0.01 − 0.03 < 0: j = 2, so v_y = −1 and v_x falls by 0.8 · 2.
    const Vec2d sliding = ground_contact<double>({0, 0.01}, {5, -3}, level, 0.8, 0.01);
    BOOST_TEST(sliding.x == 3.4, near);
    BOOST_TEST(sliding.y == -1, near);
    const Vec2d stuck = ground_contact<double>({0, 0}, {-1, -3}, level, 0.8, 0.01);
    BOOST_TEST(stuck.x == 0);
    BOOST_TEST(stuck.y == 0, near);
    const Vec2d above = ground_contact<double>({0, 1}, {5, -3}, level, 0.8, 0.01);
    BOOST_TEST((above == Vec2d{5, -3}));
}

BOOST_AUTO_TEST_CASE(on_a_slope_contact_acts_along_its_normal) {
    const GroundPlane<double> slope{{0, 0}, {-0.6, 0.8}};
    const Vec2d stopped = ground_contact<double>({0, 0}, {0, -1}, slope, 0, 0.01);
    BOOST_TEST(std::abs(dot(stopped, slope.normal)) < 1e-12);
    BOOST_TEST(dot(stopped, right_normal(slope.normal)) == dot(Vec2d{0, -1}, Vec2d{0.8, 0.6}), near);
}
