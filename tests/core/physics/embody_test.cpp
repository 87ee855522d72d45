// SPDX-License-Identifier: MIT
#include "physics/embody.h"

#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;
using namespace planula::specimens;

namespace {

/// The row of a cell among the contact cells.
std::size_t row_of(const SoftBodyModel &model, int cell) {
    return static_cast<std::size_t>(std::find(model.contact_cells.begin(), model.contact_cells.end(), cell) -
                                    model.contact_cells.begin());
}

} // namespace

BOOST_AUTO_TEST_CASE(in_water_the_centre_of_mass_is_the_origin) {
    const auto model = soft_body(lattice(5, 3), water());
    const Vec2d centre = centre_of_mass(model.positions);
    BOOST_TEST(std::abs(centre.x) < 1e-12);
    BOOST_TEST(std::abs(centre.y) < 1e-12);
}

BOOST_AUTO_TEST_CASE(on_land_the_lowest_node_touches_the_ground_at_x_zero) {
    const auto model = soft_body(lattice(5, 3), land());
    BOOST_TEST(std::abs(centre_of_mass(model.positions).x) < 1e-12);
    const auto lower = [](Vec2d a, Vec2d b) { return a.y < b.y; };
    BOOST_TEST(std::min_element(model.positions.begin(), model.positions.end(), lower)->y == 0);

    Environment ramp = land();
    ramp.ground = {{-10, -10}, {10, 10}};
    const auto tilted = soft_body(lattice(5, 3), ramp);
    double gap = 1e9;
    for (const Vec2d p : tilted.positions) gap = std::min(gap, p.y - ground_height(ramp, p.x));
    BOOST_TEST(std::abs(gap) < 1e-12);
}

BOOST_AUTO_TEST_CASE(only_solid_outline_cells_take_part_in_contact) {
    // A triangle with a tail: 3 and 4 hang on a chain.
    const Body tailed = make_body({{0, 0}, {1, 0}, {0.5, 0.8}, {2, 0}, {3, 0}}, 1.5);
    const auto model = soft_body(tailed, water());
    BOOST_TEST(model.contact_cells == (std::vector<int>{0, 1, 2}));
    for (std::size_t cell = 0; cell < 3; ++cell)
        for (std::size_t link = 0; link < model.outline.size(); ++link)
            if (!model.outline[link].solid) BOOST_TEST(model.is_masked(cell, link));

    // The inner cell of a hexagon is not on the outline.
    const auto hexagon = soft_body(lattice(3, 3), water());
    BOOST_TEST(std::count(hexagon.contact_cells.begin(), hexagon.contact_cells.end(), 4) == 0);
}

BOOST_AUTO_TEST_CASE(only_links_that_lay_in_reach_at_the_end_of_development_are_masked) {
    const Body body = lattice(6, 2); // 0 … 5 below, 6 … 11 above
    const auto model = soft_body(body, water());
    const std::size_t corner = row_of(model, 0);
    for (std::size_t link = 0; link < model.outline.size(); ++link) {
        const auto &[a, b, solid] = model.outline[link];
        BOOST_TEST(model.is_masked(corner, link) == (std::min(a, b) == 0), "link " << a << " - " << b);
    }
    Parameters wide;
    wide.body.contact_radius = 2;
    const auto wider = soft_body(body, water(), wide);
    for (std::size_t link = 0; link < wider.outline.size(); ++link) {
        const auto &l = wider.outline[link];
        const auto joins = [&](int a, int b) { return std::min(l.a, l.b) == a && std::max(l.a, l.b) == b; };
        if (joins(1, 2)) BOOST_TEST(wider.is_masked(corner, link));
        if (joins(2, 3)) BOOST_TEST(!wider.is_masked(corner, link)); // exactly 2 away: not nearer
    }
}
