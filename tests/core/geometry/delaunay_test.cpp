// SPDX-License-Identifier: MIT
#include "geometry/delaunay.h"

#include "base/error.h"
#include "base/math.h"
#include "base/random.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>

using namespace planula;

namespace {

std::vector<Vec2d> scatter(int count, std::uint64_t seed) {
    Stream stream(seed, 0, 0, Purpose::sampling);
    std::vector<Vec2d> points(static_cast<std::size_t>(count));
    for (auto &point : points) point.x = stream.uniform() * 10, point.y = stream.uniform() * 10;
    return points;
}

/// Positive if d is inside the circle through a, b, c (counter-clockwise), in extended precision.
long double in_circle(Vec2d a, Vec2d b, Vec2d c, Vec2d d) {
    using L = long double;
    const L ax = L(a.x) - d.x, ay = L(a.y) - d.y, bx = L(b.x) - d.x, by = L(b.y) - d.y;
    const L cx = L(c.x) - d.x, cy = L(c.y) - d.y;
    return (ax * ax + ay * ay) * (bx * cy - by * cx) - (bx * bx + by * by) * (ax * cy - ay * cx) +
           (cx * cx + cy * cy) * (ax * by - ay * bx);
}

} // namespace

BOOST_AUTO_TEST_CASE(few_points_are_joined_as_far_as_they_go) {
    BOOST_TEST(delaunay({}).edges.empty());
    BOOST_TEST(delaunay(scatter(1, 1)).edges.empty());
    BOOST_TEST((delaunay(scatter(2, 1)).edges == std::vector<std::array<int, 2>>{{0, 1}}));
    const Triangulation three = delaunay(scatter(3, 1));
    BOOST_TEST(three.edges.size() == 3u);
    BOOST_TEST(three.faces.size() == 1u);
}

BOOST_AUTO_TEST_CASE(collinear_points_become_a_chain_along_their_line) {
    const std::vector<Vec2d> line{{2, 2}, {0, 0}, {3, 3}, {1, 1}};
    const Triangulation chain = delaunay(line);
    BOOST_TEST((chain.edges == std::vector<std::array<int, 2>>{{0, 2}, {0, 3}, {1, 3}}));
    BOOST_TEST(chain.faces.empty());
}

BOOST_AUTO_TEST_CASE(no_point_lies_inside_the_circle_of_a_face) {
    const auto points = scatter(80, 5);
    const Triangulation mesh = delaunay(points);
    // Euler: with h points on the hull there are 3n - 3 - h edges and 2n - 2 - h faces.
    BOOST_TEST(mesh.edges.size() == mesh.faces.size() + points.size() - 1);
    for (const auto &[a, b, c] : mesh.faces) {
        BOOST_REQUIRE(cross(points[b] - points[a], points[c] - points[a]) > 0);
        BOOST_REQUIRE((a < b && a < c));
        for (const Vec2d d : points) BOOST_REQUIRE(in_circle(points[a], points[b], points[c], d) <= 1e-9L);
    }
    BOOST_TEST(std::is_sorted(mesh.edges.begin(), mesh.edges.end()));
    BOOST_TEST(std::is_sorted(mesh.faces.begin(), mesh.faces.end()));
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

BOOST_AUTO_TEST_CASE(moving_points_keep_the_triangulation_that_a_new_one_gives) {
    // A cloud that jitters and grows, inside and over its hull: mostly kept or mended, where points jump over several
    // others begun again.
    for (const double pace : {0.002, 0.02, 0.2, 0.6}) {
        Stream stream(7, 0, 0, Purpose::sampling);
        std::vector<Vec2d> points = scatter(100, 3);
        MovingDelaunay moving;
        moving.start(points);
        int followed = 0, changed = 0;
        for (int t = 0; t < 200; ++t) {
            for (auto &[x, y] : points) x += pace * stream.triangular(), y += pace * stream.triangular();
            for (int born = 0; t % 20 == 0 && born < 3; ++born) {
                points.emplace_back();
                points.back().x = 12 * stream.uniform() - 1, points.back().y = 12 * stream.uniform() - 1;
            }
            const bool could = moving.follow(points);
            if (!could) moving.start(points);
            followed += could, changed += could && moving.has_changed();
            const Triangulation anew = delaunay(points);
            BOOST_REQUIRE((moving.now().edges == anew.edges));
            BOOST_REQUIRE((moving.now().faces == anew.faces));
        }
        BOOST_TEST(followed > (pace < 0.5 ? 150 : 10), pace << ": " << followed);
        BOOST_TEST(followed < (pace < 0.5 ? 201 : 150), pace << ": " << followed);
        BOOST_TEST(changed > 10, pace << ": " << changed);
    }
}

BOOST_AUTO_TEST_CASE(moving_points_of_a_grid_break_ties_as_new_ones_do) {
    // Points hop between halves of a grid's cells: cocircular and collinear ones remain at every step.
    Stream stream(8, 0, 0, Purpose::sampling);
    std::vector<Vec2d> grid;
    for (int x = 0; x < 7; ++x)
        for (int y = 0; y < 7; ++y) grid.push_back({double(x), double(y)});
    std::vector<Vec2d> points = grid;
    MovingDelaunay moving;
    moving.start(points);
    int followed = 0, changed = 0;
    for (int t = 0; t < 400; ++t) {
        const auto i = static_cast<std::size_t>(stream.uniform() * 49);
        points[i] = grid[i];
        if (t % 3 > 0) points[i].x += t % 2 == 0 ? 0.25 : -0.25;
        if (t % 3 > 1) points[i].y += t % 4 < 2 ? 0.25 : -0.25;
        const bool could = moving.follow(points);
        if (!could) moving.start(points);
        followed += could, changed += could && moving.has_changed();
        BOOST_REQUIRE((moving.now().edges == delaunay(points).edges));
    }
    BOOST_TEST(followed > 200);
    BOOST_TEST(changed > 100);
}

BOOST_AUTO_TEST_CASE(points_that_coincide_or_lie_on_one_line_cannot_be_followed) {
    std::vector<Vec2d> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0.5, 1.5}};
    MovingDelaunay moving;
    BOOST_TEST(!moving.follow(square)); // never started
    moving.start(square);
    BOOST_TEST(moving.follow(square));
    BOOST_TEST(!moving.has_changed());
    std::vector<Vec2d> doubled = square;
    doubled.push_back(square[2]);
    BOOST_TEST(!moving.follow(doubled));
    moving.start(square);
    square[4] = square[0];
    BOOST_TEST(!moving.follow(square));
    const std::vector<Vec2d> line{{0, 0}, {1, 1}, {2, 2}};
    moving.start(line);
    BOOST_TEST(!moving.follow(line));
}

BOOST_AUTO_TEST_CASE(points_may_leave_the_hull_and_join_it) {
    const std::vector<Vec2d> square{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0.5, 1.5}};
    const auto moved = [&](int point, Vec2d place) {
        std::vector<Vec2d> points = square;
        points[point] = place;
        MovingDelaunay moving;
        moving.start(square);
        BOOST_TEST(moving.follow(points));
        BOOST_TEST(moving.has_changed());
        return moving.now().faces == delaunay(points).faces;
    };
    BOOST_TEST(moved(1, {0.95, 1.05})); // a corner inwards, past the diagonal: the hull goes from 0 to 2 now
    BOOST_TEST(moved(4, {-0.5, 1}));    // the inner point out over an edge of the hull
}

BOOST_AUTO_TEST_CASE(a_triangulation_that_winds_twice_is_not_followed) {
    // A fan about the last point whose spokes now go round it twice: every face and every turn of the hull is sound.
    std::vector<Vec2d> fan, wound;
    for (int i = 0; i < 7; ++i) {
        const double angle = 2 * math::pi * i / 7;
        fan.push_back({math::cos(angle), math::sin(angle)});
        wound.push_back({(1 + 0.01 * i) * math::cos(2 * angle), (1 + 0.01 * i) * math::sin(2 * angle)});
    }
    fan.push_back({}), wound.push_back({});
    MovingDelaunay moving;
    moving.start(fan);
    const bool could = moving.follow(wound);
    BOOST_TEST((!could || moving.now().faces == delaunay(wound).faces));
}
