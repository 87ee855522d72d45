// SPDX-License-Identifier: MIT
#include "development/tissue_forces.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

Embryo pair(double distance) {
    Embryo embryo = zygote(0);
    embryo.cells.push_back(embryo.cells[0]);
    embryo.cells[1].id = 1;
    embryo.cells[1].position = {distance, 0};
    embryo.links = {{0, 1}};
    return embryo;
}

const auto near = boost::test_tools::tolerance(1e-12);

} // namespace

BOOST_AUTO_TEST_CASE(neighbours_are_pulled_to_the_sum_of_their_radii) {
    // Rule D6: k (l − L) = 1000 · 0.2, equal and opposite.
    const auto apart = tissue_forces(pair(1.2), DevelopmentParameters{});
    BOOST_TEST(apart[0].x == 200, near);
    BOOST_TEST(apart[1].x == -200, near);
    BOOST_TEST(tissue_forces(pair(0.7), DevelopmentParameters{})[0].x == -300, near);
    BOOST_TEST((tissue_forces(pair(0), DevelopmentParameters{})[0] == Vec2d{}));
}

BOOST_AUTO_TEST_CASE(damping_acts_along_the_link_and_the_fluid_on_all_motion) {
    Embryo embryo = pair(1);
    embryo.cells[1].velocity = {2, 3};
    const auto forces = tissue_forces(embryo, DevelopmentParameters{});
    BOOST_TEST(forces[0].x == 20, near);       // c · dl/dt
    BOOST_TEST(forces[0].y == 0);              // across the link there is no damping
    BOOST_TEST(forces[1].x == -20 - 20, near); // and −γv
    BOOST_TEST(forces[1].y == -30, near);
}

BOOST_AUTO_TEST_CASE(a_step_is_semi_implicit_euler) {
    Embryo embryo = pair(1.2);
    relax(DevelopmentParameters{}, embryo);
    BOOST_TEST(embryo.cells[0].velocity.x == 2, near);    // 200 · 0.01
    BOOST_TEST(embryo.cells[0].position.x == 0.02, near); // with the new velocity
}

BOOST_AUTO_TEST_CASE(speed_is_clamped_in_its_direction) {
    Embryo embryo = pair(1);
    embryo.links.clear();
    embryo.cells[0].velocity = {300, 400};
    relax(DevelopmentParameters{}, embryo);
    BOOST_TEST(embryo.cells[0].velocity.x == 30, near); // 0.5 cells a step are 50 cells/t.u.
    BOOST_TEST(embryo.cells[0].velocity.y == 40, near);
}

BOOST_AUTO_TEST_CASE(a_newborn_overlap_relaxes_within_one_decision_interval) {
    Embryo embryo = pair(0.5);
    for (int i = 0; i < 30; ++i) relax(DevelopmentParameters{}, embryo);
    BOOST_TEST(std::abs(length(embryo.cells[1].position - embryo.cells[0].position) - 1) < 0.01);
}
