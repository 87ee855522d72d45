// SPDX-License-Identifier: MIT
#include "body/damage.h"

#include "base/error.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <numeric>

using namespace planula;
using namespace planula::specimens;

namespace {

std::vector<Vec2d> places(const Body &body, const std::vector<int> &cells) {
    std::vector<Vec2d> result;
    for (const int cell : cells) result.push_back(body.positions[cell]);
    return result;
}

Damage from(Side side, double share) { return {.share = share, .side = side}; }

std::string refusal(const Damage &damage) {
    try {
        check_damage(damage);
    } catch (const InputError &error) {
        return error.what();
    }
    return "";
}

} // namespace

BOOST_AUTO_TEST_CASE(a_side_is_lost_up_to_the_share) {
    const Body body = lattice(9, 9);
    const Vec2d centre = centre_of_mass(body.positions);
    const auto ahead = [&](Side side, Vec2d place) {
        const Vec2d p = place - centre;
        switch (side) {
        case Side::left:
            return -p.x;
        case Side::right:
            return p.x;
        case Side::bottom:
            return -p.y;
        case Side::top:
            return p.y;
        case Side::middle:
            return -squared_length(p);
        default:
            return squared_length(p);
        }
    };
    for (const Side side : {Side::left, Side::right, Side::bottom, Side::top, Side::middle, Side::edge}) {
        const auto kept = cells_left(body, from(side, 0.25));
        BOOST_TEST(kept.size() == 61u);
        BOOST_TEST(std::ranges::is_sorted(kept));
        double most = -1e9, least = 1e9; // of kept and of lost cells
        for (int cell = 0; cell < body.cells(); ++cell) {
            const double where = ahead(side, body.positions[cell]);
            if (std::ranges::binary_search(kept, cell))
                most = std::max(most, where);
            else
                least = std::min(least, where);
        }
        BOOST_TEST(most <= least);
    }
}

BOOST_AUTO_TEST_CASE(shares_are_rounded_and_nothing_and_all_can_be_lost) {
    const Body body = lattice(5, 2);
    for (const Side side : {Side::left, Side::middle, Side::random}) {
        BOOST_TEST(cells_left(body, from(side, 0)).size() == 10u);
        BOOST_TEST(cells_left(body, from(side, 0.049)).size() == 10u);
        BOOST_TEST(cells_left(body, from(side, 1)).empty());
    }
    BOOST_TEST(cells_left(body, from(Side::left, 0.05)).size() == 9u);
}

BOOST_AUTO_TEST_CASE(a_box_is_seen_from_the_centre_of_mass) {
    Body body = lattice(8, 3);
    for (Vec2d &p : body.positions) p += Vec2d{100, 50};
    const Vec2d centre = centre_of_mass(body.positions);
    for (const Vec2d place : places(body, cells_left(body, {.within = Box{.left = 0}})))
        BOOST_TEST(place.x < centre.x);
    BOOST_TEST(cells_left(body, {.within = Box{.left = 50}}).size() == 24u);
    BOOST_TEST(cells_left(body, {.within = Box{}}).empty());
}

BOOST_AUTO_TEST_CASE(the_largest_part_that_holds_together_is_left) {
    // A bar that is cut, nearer to its right end.
    const Body bar = lattice(12, 2);
    const auto kept = cells_left(bar, {.within = Box{.left = 1.1, .right = 2.9}});
    for (const Vec2d place : places(bar, kept)) BOOST_TEST(place.x < centre_of_mass(bar.positions).x + 1.1);
    const Body part = part_of(bar, kept);
    BOOST_TEST(cells_left(part, {}).size() == static_cast<std::size_t>(part.cells()));

    // Of equal parts that with the lowest cell.
    const Body pairs = make_body({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}}, 1.5);
    BOOST_TEST(cells_left(pairs, {.within = Box{.left = -0.1, .right = 0.1}}) == (std::vector<int>{0, 1}));
}

BOOST_AUTO_TEST_CASE(what_is_left_keeps_its_measures) {
    for (const Body &body : {hook(), lattice(7, 5), two_arms(3)})
        for (const Side side : {Side::left, Side::top, Side::middle, Side::random}) {
            const auto kept = cells_left(body, from(side, 0.3));
            const Body part = part_of(body, kept);
            BOOST_TEST(part.positions == places(body, kept));
            BOOST_TEST(std::ranges::is_sorted(part.mesh.links));
            BOOST_TEST(std::ranges::is_sorted(part.mesh.triangles));
            std::size_t links = 0;
            for (std::size_t i = 0; i < body.mesh.links.size(); ++i) {
                const auto [a, b] = body.mesh.links[i];
                if (!std::ranges::binary_search(kept, a) || !std::ranges::binary_search(kept, b)) continue;
                const auto [c, d] = part.mesh.links[links];
                BOOST_TEST((kept[c] == a && kept[d] == b));
                BOOST_TEST(part.rest_lengths[links++] == body.rest_lengths[i]);
            }
            BOOST_TEST(links == part.mesh.links.size());
            for (std::size_t i = 0; i < part.areas.size(); ++i) {
                const auto [a, b, c] = part.mesh.triangles[i];
                const double area =
                    0.5 * cross(part.positions[b] - part.positions[a], part.positions[c] - part.positions[a]);
                BOOST_TEST(std::abs(part.areas[i] - area) < 1e-12);
            }
            const auto rim = outline(part.mesh);
            BOOST_TEST(part.outline.size() == rim.size());
        }
    std::vector<int> all(35);
    std::iota(all.begin(), all.end(), 0);
    const Body body = lattice(7, 5), same = part_of(body, all);
    BOOST_TEST(same.rest_lengths == body.rest_lengths);
    BOOST_TEST(same.areas == body.areas);
}

BOOST_AUTO_TEST_CASE(random_damage_hits_all_over_the_body_and_is_always_the_same) {
    const Body body = lattice(10, 10);
    const auto kept = cells_left(body, from(Side::random, 0.2));
    BOOST_TEST(kept == cells_left(body, from(Side::random, 0.2)));
    int left = 0;
    for (int cell = 0; cell < 100; ++cell)
        if (!std::ranges::binary_search(kept, cell) && body.positions[cell].x < 4.75) ++left;
    BOOST_TEST(left > 3);
    BOOST_TEST(left < 17);
}

BOOST_AUTO_TEST_CASE(damage_that_makes_no_sense_is_refused_with_the_rule) {
    BOOST_TEST(refusal({.at = -10}) == "damage: at is a step of locomotion, 0 or more, not -10");
    BOOST_TEST(refusal({.share = 1.5}) == "damage: share is a share of the cells, 0 to 1, not 1.5");
    BOOST_TEST(refusal({.within = Box{.left = 1, .right = 1}}) ==
               "damage: within.from must be less than within.to, not 1");
    BOOST_TEST(refusal({.within = Box{.bottom = 2, .top = 1}}) ==
               "damage: within.bottom must be less than within.top, not 2");
    BOOST_TEST(refusal({.share = 0.5}).empty());
}
