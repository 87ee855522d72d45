// SPDX-License-Identifier: MIT
#include "geometry/delaunay.h"

#include "base/error.h"
#include "support/points.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>

using namespace planula;
using planula::test::scatter;

namespace {

/// Positive if d is inside the circle through a, b, c (counter-clockwise), in extended precision.
long double in_circle(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
    using L = long double;
    const L ax = L(a.x) - d.x, ay = L(a.y) - d.y, bx = L(b.x) - d.x, by = L(b.y) - d.y;
    const L cx = L(c.x) - d.x, cy = L(c.y) - d.y;
    return (ax * ax + ay * ay) * (bx * cy - by * cx) - (bx * bx + by * by) * (ax * cy - ay * cx) +
           (cx * cx + cy * cy) * (ax * by - ay * bx);
}

} // namespace

BOOST_AUTO_TEST_CASE(one_point_has_no_edge_and_two_have_one) {
    BOOST_TEST(delaunay({}).edges.empty());
    BOOST_TEST(delaunay(scatter(1, 1)).edges.empty());
    BOOST_TEST((delaunay(scatter(2, 1)).edges == std::vector<std::array<int, 2>>{{0, 1}}));
    const Triangulation three = delaunay(scatter(3, 1));
    BOOST_TEST(three.edges.size() == 3u);
    BOOST_TEST(three.triangles.size() == 1u);
}

BOOST_AUTO_TEST_CASE(collinear_points_become_a_chain_along_their_line) {
    const std::vector<Vec2d> line{{2, 2}, {0, 0}, {3, 3}, {1, 1}};
    const Triangulation chain = delaunay(line);
    BOOST_TEST((chain.edges == std::vector<std::array<int, 2>>{{0, 2}, {0, 3}, {1, 3}}));
    BOOST_TEST(chain.triangles.empty());
}

BOOST_AUTO_TEST_CASE(no_point_lies_inside_the_circle_of_a_face) {
    const auto points = scatter(80, 5);
    const Triangulation mesh = delaunay(points);
    // Euler: with h points on the hull there are 3n - 3 - h edges and 2n - 2 - h faces.
    BOOST_TEST(mesh.edges.size() == mesh.triangles.size() + points.size() - 1);
    for (const auto &[a, b, c] : mesh.triangles) {
        BOOST_REQUIRE(cross(points[b] - points[a], points[c] - points[a]) > 0);
        BOOST_REQUIRE((a < b && a < c));
        for (const Vec2d d : points) BOOST_REQUIRE(in_circle(points[a], points[b], points[c], d) <= 1e-9L);
    }
    BOOST_TEST(std::is_sorted(mesh.edges.begin(), mesh.edges.end()));
    BOOST_TEST(std::is_sorted(mesh.triangles.begin(), mesh.triangles.end()));
}

BOOST_AUTO_TEST_CASE(the_order_of_the_points_does_not_matter_even_where_four_share_a_circle) {
    std::vector<Vec2d> grid;
    for (int x = 0; x < 6; ++x)
        for (int y = 0; y < 6; ++y) grid.push_back({double(x), double(y)});
    const Triangulation forward = delaunay(grid);
    const int n = static_cast<int>(grid.size());
    std::reverse(grid.begin(), grid.end());
    Triangulation backward = delaunay(grid);
    for (auto &[a, b] : backward.edges) a = n - 1 - a, b = n - 1 - b, std::swap(a, b);
    std::sort(backward.edges.begin(), backward.edges.end());
    BOOST_TEST((forward.edges == backward.edges));
}

BOOST_AUTO_TEST_CASE(points_that_would_be_lost_are_refused) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_THROW(delaunay(std::vector<Vec2d>{{0, 0}, {1, 0}, {0, nan}}), InternalError);
    BOOST_CHECK_THROW(delaunay(std::vector<Vec2d>{{0, 0}, {1, 0}, {0, 1}, {1, 0}}), InternalError);
}
