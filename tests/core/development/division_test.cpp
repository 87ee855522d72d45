// SPDX-License-Identifier: MIT
#include "development/division.h"

#include <boost/test/unit_test.hpp>

#include <set>
#include <utility>
#include <vector>

using namespace planula;

namespace {

/// Cells at these places, all neighbours of the first.
Embryo star(std::vector<Vec2d> places) {
    Embryo embryo = zygote(2);
    for (std::size_t i = 1; i < places.size(); ++i) {
        embryo.cells.push_back(embryo.cells[0]);
        embryo.cells.back().id = static_cast<int>(i);
        embryo.links.push_back({0, static_cast<int>(i)});
        embryo.activations.append_copy(0);
    }
    for (std::size_t i = 0; i < places.size(); ++i) embryo.cells[i].position = places[i];
    embryo.births = embryo.largest = static_cast<int>(places.size());
    embryo.neighbours = Neighbours(embryo.links, static_cast<int>(places.size()));
    return embryo;
}

constexpr auto near = 1e-12;

} // namespace

BOOST_AUTO_TEST_CASE(the_direction_is_the_mean_of_the_neighbours_turned_by_the_angle_output) {
    Parameters full;
    full.development.division_angle_range = 1;
    Embryo embryo = star({{0, 0}, {1, 0}, {0, 1}});
    embryo.cells[1].orientation = {1, 0};
    embryo.cells[2].orientation = {0, 1};
    const Vec2d mean = division_direction(embryo, 0, 0, full.development);
    BOOST_TEST(length(mean - Vec2d{std::sqrt(0.5), std::sqrt(0.5)}) < near);
    const Vec2d turned = division_direction(embryo, 0, 0.25, full.development); // + 45 degrees
    BOOST_TEST(length(turned - Vec2d{0, 1}) < near);
    BOOST_TEST(length(division_direction(embryo, 0, 1, full.development) + mean) < near);
    Parameters narrow;
    narrow.development.division_angle_range = 0.25;
    BOOST_TEST(length(division_direction(embryo, 0, 1, narrow.development) - turned) < near);
}

BOOST_AUTO_TEST_CASE(without_neighbours_or_if_they_cancel_a_cell_takes_its_own_orientation) {
    Embryo alone = zygote(1);
    alone.cells[0].orientation = {0, -1};
    BOOST_TEST(length(division_direction(alone, 0, 0, {}) - Vec2d{0, -1}) < near);

    Embryo torn = star({{0, 0}, {1, 0}, {-1, 0}});
    torn.cells[0].orientation = {0, 1};
    torn.cells[1].orientation = {0.6, 0.8};
    torn.cells[2].orientation = {-0.6, -0.8};
    BOOST_TEST(length(division_direction(torn, 0, 0, {}) - Vec2d{0, 1}) < near);
}

BOOST_AUTO_TEST_CASE(a_daughter_touches_her_mother_and_inherits) {
    Embryo embryo = zygote(3);
    embryo.cells[0].velocity = {0.5, -0.25};
    embryo.cells[0].morphogen = 0.75;
    for (int node = 0; node < 3; ++node) embryo.activations.at(0, node) = node + 1;
    const Parameters p;
    BOOST_TEST(divide(0, {0, 1}, p.development, embryo));
    BOOST_REQUIRE(embryo.cells.size() == 2u);
    const Cell &mother = embryo.cells[0], &daughter = embryo.cells[1];
    BOOST_TEST(length(daughter.position - Vec2d{0, 1}) <= p.development.division_jitter * (1 + near));
    BOOST_TEST(length(daughter.position - Vec2d{0, 1}) > 0);
    BOOST_TEST((daughter.velocity == mother.velocity));
    BOOST_TEST(daughter.morphogen == 0.75);
    BOOST_TEST(embryo.activations.cells() == 2);
    for (int node = 0; node < 3; ++node) BOOST_TEST(embryo.activations.at(1, node) == node + 1);
    BOOST_TEST(daughter.id == 1);
    BOOST_TEST(embryo.births == 2);
    BOOST_TEST(embryo.largest == 2);
}

BOOST_AUTO_TEST_CASE(division_turn_says_which_cells_take_the_direction) {
    const auto orientations = [](DivisionTurn turn) {
        Parameters p;
        p.development.division_turn = turn;
        Embryo embryo = zygote(1);
        BOOST_REQUIRE(divide(0, {0, 1}, p.development, embryo));
        return std::pair(embryo.cells[0].orientation, embryo.cells[1].orientation);
    };
    const Vec2d before{1, 0}, direction{0, 1};
    BOOST_TEST((orientations(DivisionTurn::nobody) == std::pair(before, before)));
    BOOST_TEST((orientations(DivisionTurn::daughter) == std::pair(before, direction)));
    BOOST_TEST((orientations(DivisionTurn::both) == std::pair(direction, direction)));
}

BOOST_AUTO_TEST_CASE(orientations_turn_as_the_links_of_a_cell_do) {
    // A rigid rotation by 90 degrees and a shift; the last cell has no link.
    Embryo embryo = star({{0, 0}, {1, 0}, {0, 1}});
    embryo.cells.push_back(embryo.cells[0]);
    embryo.cells[1].orientation = {0.6, 0.8};
    const std::vector<Vec2d> places = positions(embryo);
    for (Cell &cell : embryo.cells)
        cell.position = Vec2d{-cell.position.y, cell.position.x} * 3 + Vec2d{5, 7};
    carry_orientations(places, embryo);
    BOOST_TEST(length(embryo.cells[0].orientation - Vec2d{0, 1}) < near);
    BOOST_TEST(length(embryo.cells[1].orientation - Vec2d{-0.8, 0.6}) < near);
    BOOST_TEST((embryo.cells[3].orientation == Vec2d{1, 0}));

    // Links that turn unequally: the angle of Σ (dot, cross), the longer links counting for more.
    Embryo torn = star({{0, 0}, {1, 0}, {-2, 0}});
    const std::vector<Vec2d> straight = positions(torn);
    torn.cells[1].position = {0, 1};
    carry_orientations(straight, torn);
    BOOST_TEST(length(torn.cells[0].orientation - Vec2d{4, 1} / std::sqrt(17.0)) < near);
    BOOST_TEST(length(torn.cells[2].orientation - Vec2d{1, 0}) < near);
}

BOOST_AUTO_TEST_CASE(division_needs_room_for_the_daughter_but_not_from_the_mother) {
    Parameters p;
    p.development.division_jitter = 0;
    // Exactly at the clearance (a binary fraction) there is room; slightly nearer there is no room, and nothing
    // changes.
    p.development.division_clearance = 0.4375;
    Embryo free = star({{0, 0}, {1 + p.development.division_clearance, 0}});
    BOOST_TEST(divide(0, {1, 0}, p.development, free));
    Embryo full = star({{0, 0}, {1 + p.development.division_clearance - 1e-9, 0}});
    full.cells[0].orientation = {0, 1};
    BOOST_TEST(!divide(0, {1, 0}, p.development, full));
    BOOST_TEST(full.cells.size() == 2u);
    BOOST_TEST(full.births == 2);
    BOOST_TEST((full.cells[0].orientation == Vec2d{0, 1}));
    // A clearance beyond the mother's own distance does not count her.
    p.development.division_clearance = 1;
    BOOST_TEST(divide(0, {-1, 0}, p.development, full));
}

BOOST_AUTO_TEST_CASE(the_offset_depends_on_the_daughters_lineage_alone_and_stays_small) {
    const Parameters p;
    for (int id = 0; id < 1024; ++id) {
        const Vec2d offset = daughter_position({0, 0}, {1, 0}, id, p.development) - Vec2d{1, 0};
        BOOST_REQUIRE(length(offset) <= p.development.division_jitter * (1 + near));
        const Vec2d elsewhere = daughter_position({0, 0}, {0, 1}, id, p.development) - Vec2d{0, 1};
        BOOST_REQUIRE(length(offset - elsewhere) < near);
    }
    const auto x = [&](int id) { return daughter_position({0, 0}, {1, 0}, id, p.development).x; };
    BOOST_TEST(x(1) != x(2));
}

BOOST_AUTO_TEST_CASE(a_birth_elsewhere_does_not_change_the_place_of_a_daughter) {
    // Two far mothers: the second's daughter lies where she would if the first had not divided.
    const Parameters p;
    Embryo both = star({{0, 0}, {50, 0}}), one = both;
    both.cells[1].lineage = one.cells[1].lineage = 7;
    BOOST_REQUIRE((divide(0, {1, 0}, p.development, both) && divide(1, {1, 0}, p.development, both) &&
                   divide(1, {1, 0}, p.development, one)));
    BOOST_TEST((both.cells.back().position == one.cells.back().position));
    BOOST_TEST(both.cells.back().lineage == one.cells.back().lineage);
    BOOST_TEST(both.cells.back().id != one.cells.back().id);
}

BOOST_AUTO_TEST_CASE(every_cell_has_a_lineage_of_its_own) {
    Parameters p;
    p.development.division_clearance = 0;
    Embryo embryo = zygote(1);
    for (int round = 0; round < 7; ++round)
        for (int cell = static_cast<int>(embryo.cells.size()); cell-- > 0;)
            divide(cell, {1, 0}, p.development, embryo);
    std::set<std::uint64_t> lineages;
    for (const Cell &cell : embryo.cells) lineages.insert(cell.lineage);
    BOOST_TEST(embryo.cells.size() == 128u);
    BOOST_TEST(lineages.size() == embryo.cells.size());
}

BOOST_AUTO_TEST_CASE(dead_cells_are_removed_and_the_others_keep_their_order) {
    Embryo embryo = star({{0, 0}, {1, 0}, {0, 1}, {-1, 0}});
    remove_cells(std::vector<char>{1, 0, 1, 0}, embryo);
    BOOST_REQUIRE(embryo.cells.size() == 2u);
    BOOST_TEST(embryo.cells[0].id == 1);
    BOOST_TEST(embryo.cells[1].id == 3);
}
