// SPDX-License-Identifier: MIT
#include "body/connect.h"

#include "base/random.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;

namespace {

bool has(const Mesh &mesh, int a, int b) {
    return std::find(mesh.links.begin(), mesh.links.end(), Link{a, b}) != mesh.links.end();
}

} // namespace

BOOST_AUTO_TEST_CASE(links_up_to_the_limit_stay_and_longer_ones_are_left_out) {
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
    // Two triangles far apart: of the long Delaunay links between them only the shortest is kept.
    const std::vector<Vec2d> apart{{0, 0}, {1, 0}, {0.5, 0.8}, {4, 0.1}, {5, 0}, {4.5, 0.8}};
    const Mesh mesh = connect(apart, 1.5);
    BOOST_TEST(mesh.links.size() == 7u);
    BOOST_TEST(has(mesh, 1, 3));
    BOOST_TEST(mesh.triangles.size() == 2u);
}

BOOST_AUTO_TEST_CASE(bridges_are_kept_shortest_first) {
    // Three far points: the two shorter sides join them, the longest is left out.
    const Mesh mesh = connect(std::vector<Vec2d>{{0, 0}, {3, 0}, {0, 4}}, 1.5);
    BOOST_TEST((mesh.links == std::vector<Link>{{0, 1}, {0, 2}}));
}

BOOST_AUTO_TEST_CASE(the_mesh_of_moving_cells_is_that_of_new_ones) {
    // A dense cloud, and one so thin that links disappear and come back and bridges change.
    Stream stream(5, 0, 0, Purpose::sampling);
    int followed = 0, unchanged = 0;
    for (const double width : {5, 9}) {
        std::vector<Vec2d> cells(60);
        for (auto &[x, y] : cells) x = width * stream.uniform(), y = width * stream.uniform();
        Connection connection(1.5);
        connection.start(cells);
        for (int t = 0; t < 400; ++t) {
            const double pace = t < 200 ? 0.001 : 0.03;
            for (auto &[x, y] : cells) x += pace * stream.triangular(), y += pace * stream.triangular();
            const bool could = connection.follow(cells);
            if (!could) connection.start(cells);
            followed += could, unchanged += !connection.has_changed();
            const Mesh renewed = connect(cells, 1.5);
            BOOST_REQUIRE((connection.mesh().links == renewed.links));
            BOOST_REQUIRE((connection.mesh().triangles == renewed.triangles));
        }
    }
    BOOST_TEST(followed > 200);
    BOOST_TEST(unchanged > 50);
    BOOST_TEST(unchanged < 400);
}

BOOST_AUTO_TEST_CASE(coincident_points_are_found) {
    BOOST_TEST(has_coincident_points(std::vector<Vec2d>{{0, 0}, {1, 0}, {0, 0}}));
    BOOST_TEST(!has_coincident_points(std::vector<Vec2d>{{0, 0}, {1, 0}, {0, 1e-300}}));
}
