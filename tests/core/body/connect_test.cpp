// SPDX-License-Identifier: MIT
#include "body/connect.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;

namespace {

bool has(const Mesh &mesh, int a, int b) {
    return std::find(mesh.links.begin(), mesh.links.end(), Link{a, b}) != mesh.links.end();
}

} // namespace

BOOST_AUTO_TEST_CASE(links_up_to_the_limit_stay_and_longer_ones_go) {
    // A flat isosceles triangle: its base is longer than the limit, and the apex joins its ends.
    const Mesh open = connect(std::vector<Vec2d>{{0, 0}, {1.6, 0}, {0.8, 0.7}}, 1.5);
    BOOST_TEST(open.links.size() == 2u);
    BOOST_TEST(!has(open, 0, 1));
    BOOST_TEST(open.triangles.empty());

    // At the limit exactly it stays.
    const Mesh closed = connect(std::vector<Vec2d>{{0, 0}, {1.5, 0}, {0.75, 0.7}}, 1.5);
    BOOST_TEST(closed.links.size() == 3u);
    BOOST_TEST((closed.triangles == std::vector<Triangle>{{0, 1, 2}}));
}

BOOST_AUTO_TEST_CASE(a_long_link_stays_if_it_alone_holds_the_body_together) {
    // Two triangles far apart: the shortest of the long Delaunay links between them survives, and only that.
    const std::vector<Vec2d> apart{{0, 0}, {1, 0}, {0.5, 0.8}, {4, 0.1}, {5, 0}, {4.5, 0.8}};
    const Mesh mesh = connect(apart, 1.5);
    BOOST_TEST(mesh.links.size() == 7u);
    BOOST_TEST(has(mesh, 1, 3));
    BOOST_TEST(mesh.triangles.size() == 2u);
}

BOOST_AUTO_TEST_CASE(bridges_are_kept_shortest_first) {
    // Three far points: the two shorter sides join them, the longest goes.
    const Mesh mesh = connect(std::vector<Vec2d>{{0, 0}, {3, 0}, {0, 4}}, 1.5);
    BOOST_TEST((mesh.links == std::vector<Link>{{0, 1}, {0, 2}}));
}

BOOST_AUTO_TEST_CASE(coincident_points_are_found) {
    BOOST_TEST(has_coincident_points(std::vector<Vec2d>{{0, 0}, {1, 0}, {0, 0}}));
    BOOST_TEST(!has_coincident_points(std::vector<Vec2d>{{0, 0}, {1, 0}, {0, 1e-300}}));
}
