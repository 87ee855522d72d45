// SPDX-License-Identifier: MIT
// The layout of nodes in groups.
#include "physics/native/layout.h"

#include "physics/embody.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <set>

using namespace planula;
using namespace planula::specimens;

namespace {

/// Neighbours of each cell in the order of its slots, without those that are the node itself.
std::vector<std::vector<int>> fans(const native::Layout &layout) {
    std::vector<std::vector<int>> result(static_cast<std::size_t>(layout.nodes));
    for (int node = 0; node < layout.nodes; ++node) {
        const native::GroupPair &pair = layout.pairs[node / native::pair_size];
        for (int i = 0; i < pair.slots[node % native::pair_size / native::group_size]; ++i) {
            const int other =
                static_cast<int>(layout.slots[pair.first_slot + i].neighbour[node % native::pair_size] / 4);
            if (other != node) result[layout.cell_of[node]].push_back(layout.cell_of[other]);
        }
    }
    return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(every_cell_has_one_slot_for_each_neighbour) {
    for (const Body &body : {lattice(7, 4), hook(), u_body(1), two_arms(3), lattice(1, 1)}) {
        const auto model = soft_body(body, water());
        const auto layout = native::lay_out(model);
        std::set<int> cells(layout.cell_of.begin(), layout.cell_of.end());
        BOOST_TEST(static_cast<int>(cells.size()) == model.nodes());
        BOOST_TEST(layout.cell_of.size() == native::pair_size * layout.pairs.size());
        auto found = fans(layout);
        for (auto &fan : found) std::sort(fan.begin(), fan.end());
        const Neighbours expected(body.mesh.links, body.cells());
        for (int cell = 0; cell < body.cells(); ++cell)
            BOOST_TEST(std::ranges::equal(found[cell], expected[cell]));
    }
}

BOOST_AUTO_TEST_CASE(fans_turn_counter_clockwise_and_every_triangle_has_three_corners) {
    for (const Body &body : {lattice(7, 4), hook(), two_arms(3)}) {
        const auto model = soft_body(body, water());
        const auto layout = native::lay_out(model);
        int corners = 0;
        for (int node = 0; node < layout.nodes; ++node) {
            const native::GroupPair &pair = layout.pairs[node / native::pair_size];
            const int lane = node % native::pair_size;
            const auto place = [&](native::Place p) { return model.positions[layout.cell_of[p / 4]]; };
            const Vec2d own = model.positions[layout.cell_of[node]];
            Vec2d before = place(pair.last[lane]) - own;
            for (int i = 0; i < pair.slots[node % native::pair_size / native::group_size]; ++i) {
                const native::Slot &slot = layout.slots[pair.first_slot + i];
                const Vec2d offset = place(slot.neighbour[lane]) - own;
                if (slot.pressure_slope[lane] > 0) {
                    ++corners;
                    BOOST_TEST(cross(before, offset) == slot.twice_area[lane],
                               boost::test_tools::tolerance(1e-6));
                }
                before = offset;
            }
        }
        BOOST_TEST(corners == 3 * static_cast<int>(model.triangles.size()));
    }
}

BOOST_AUTO_TEST_CASE(inner_nodes_come_before_those_of_the_outline) {
    const auto model = soft_body(lattice(7, 4), water());
    const auto layout = native::lay_out(model);
    std::set<int> outline;
    for (const OutlineLink &link : model.outline) outline.insert({link.a, link.b});
    BOOST_TEST(layout.first_outline_node == model.nodes() - static_cast<int>(outline.size()));
    for (int node = 0; node < layout.nodes; ++node)
        BOOST_TEST(outline.contains(layout.cell_of[node]) == (node >= layout.first_outline_node));
}
