// SPDX-License-Identifier: MIT
#include "development/division.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

/// Cells at these places, all neighbours of the first.
Embryo star(std::vector<Vec2d> places) {
    Embryo embryo = zygote(2);
    for (std::size_t i = 1; i < places.size(); ++i) {
        embryo.cells.push_back(embryo.cells[0]);
        embryo.cells.back().id = static_cast<int>(i);
        embryo.links.push_back({0, static_cast<int>(i)});
    }
    for (std::size_t i = 0; i < places.size(); ++i) embryo.cells[i].position = places[i];
    embryo.births = embryo.largest = static_cast<int>(places.size());
    embryo.neighbours = Neighbours(embryo.links, static_cast<int>(places.size()));
    return embryo;
}

constexpr auto near = 1e-12;

} // namespace

BOOST_AUTO_TEST_CASE(the_direction_is_the_mean_of_the_neighbours_turned_by_the_angle_output) {
    Embryo embryo = star({{0, 0}, {1, 0}, {0, 1}});
    embryo.cells[1].orientation = {1, 0};
    embryo.cells[2].orientation = {0, 1};
    const Vec2d mean = division_direction(embryo, 0, 0);
    BOOST_TEST(length(mean - Vec2d{std::sqrt(0.5), std::sqrt(0.5)}) < near);
    const Vec2d turned = division_direction(embryo, 0, 0.25); // + 45 degrees
    BOOST_TEST(length(turned - Vec2d{0, 1}) < near);
    BOOST_TEST(length(division_direction(embryo, 0, 1) + mean) < near);
}

BOOST_AUTO_TEST_CASE(without_neighbours_or_if_they_cancel_a_cell_follows_itself) {
    Embryo alone = zygote(1);
    alone.cells[0].orientation = {0, -1};
    BOOST_TEST(length(division_direction(alone, 0, 0) - Vec2d{0, -1}) < near);

    Embryo torn = star({{0, 0}, {1, 0}, {-1, 0}});
    torn.cells[0].orientation = {0, 1};
    torn.cells[1].orientation = {0.6, 0.8};
    torn.cells[2].orientation = {-0.6, -0.8};
    BOOST_TEST(length(division_direction(torn, 0, 0) - Vec2d{0, 1}) < near);
}

BOOST_AUTO_TEST_CASE(a_daughter_touches_her_mother_and_inherits) {
    Embryo embryo = zygote(3);
    embryo.cells[0].velocity = {0.5, -0.25};
    embryo.cells[0].morphogen = 0.75;
    for (int node = 0; node < 3; ++node) embryo.activations.at(0, node) = node + 1;
    const Parameters p;
    BOOST_TEST(divide(0, {0, 1}, p, embryo));
    BOOST_REQUIRE(embryo.cells.size() == 2u);
    const Cell &mother = embryo.cells[0], &daughter = embryo.cells[1];
    BOOST_TEST(length(daughter.position - Vec2d{0, 1}) <= p.division_jitter * (1 + near));
    BOOST_TEST(length(daughter.position - Vec2d{0, 1}) > 0);
    BOOST_TEST((daughter.velocity == mother.velocity));
    BOOST_TEST(daughter.morphogen == 0.75);
    BOOST_TEST(embryo.activations.cells() == 2);
    for (int node = 0; node < 3; ++node) BOOST_TEST(embryo.activations.at(1, node) == node + 1);
    BOOST_TEST((mother.orientation == Vec2d{0, 1}));
    BOOST_TEST((daughter.orientation == Vec2d{0, 1}));
    BOOST_TEST(daughter.id == 1);
    BOOST_TEST(embryo.births == 2);
    BOOST_TEST(embryo.largest == 2);
}

BOOST_AUTO_TEST_CASE(division_needs_room_for_the_daughter_but_not_from_the_mother) {
    Parameters p;
    p.division_jitter = 0;
    // Exactly at the clearance (a binary fraction) there is room; a hair nearer there is none, and nothing
    // changes.
    p.division_clearance = 0.4375;
    Embryo free = star({{0, 0}, {1 + p.division_clearance, 0}});
    BOOST_TEST(divide(0, {1, 0}, p, free));
    Embryo full = star({{0, 0}, {1 + p.division_clearance - 1e-9, 0}});
    full.cells[0].orientation = {0, 1};
    BOOST_TEST(!divide(0, {1, 0}, p, full));
    BOOST_TEST(full.cells.size() == 2u);
    BOOST_TEST(full.births == 2);
    BOOST_TEST((full.cells[0].orientation == Vec2d{0, 1}));
    // A clearance beyond the mother's own distance does not count her.
    p.division_clearance = 1;
    BOOST_TEST(divide(0, {-1, 0}, p, full));
}

BOOST_AUTO_TEST_CASE(the_offset_depends_on_the_daughters_id_alone_and_stays_small) {
    const Parameters p;
    for (int id = 0; id < 1024; ++id) {
        const Vec2d offset = daughter_position({0, 0}, {1, 0}, id, p) - Vec2d{1, 0};
        BOOST_REQUIRE(length(offset) <= p.division_jitter * (1 + near));
        const Vec2d elsewhere = daughter_position({0, 0}, {0, 1}, id, p) - Vec2d{0, 1};
        BOOST_REQUIRE(length(offset - elsewhere) < near);
    }
    const auto x = [&](int id) { return daughter_position({0, 0}, {1, 0}, id, p).x; };
    BOOST_TEST(x(1) != x(2));
}

BOOST_AUTO_TEST_CASE(the_dead_leave_and_the_others_keep_their_order) {
    Embryo embryo = star({{0, 0}, {1, 0}, {0, 1}, {-1, 0}});
    remove_cells(std::vector<char>{1, 0, 1, 0}, embryo);
    BOOST_REQUIRE(embryo.cells.size() == 2u);
    BOOST_TEST(embryo.cells[0].id == 1);
    BOOST_TEST(embryo.cells[1].id == 3);
}
