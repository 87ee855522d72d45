// SPDX-License-Identifier: MIT
#include "geometry/moving_delaunay.h"

#include "base/math.h"
#include "base/random.h"
#include "support/points.h"

#include <boost/test/unit_test.hpp>

#include <span>
#include <utility>

using namespace planula;
using planula::test::scatter;

BOOST_AUTO_TEST_CASE(moving_points_keep_the_triangulation_that_a_new_one_gives) {
    // A cloud that jitters and grows, inside and over its hull: mostly kept or repaired; where points jump over several
    // others it is started again.
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
            const Triangulation renewed = delaunay(points);
            BOOST_REQUIRE((moving.edges() == renewed.edges));
            BOOST_REQUIRE((moving.triangles() == renewed.triangles));
        }
        BOOST_TEST(followed > (pace < 0.5 ? 150 : 10), pace << ": " << followed);
        BOOST_TEST(followed < (pace < 0.5 ? 201 : 150), pace << ": " << followed);
        BOOST_TEST(changed > 10, pace << ": " << changed);
    }
}

BOOST_AUTO_TEST_CASE(moving_points_of_a_grid_break_ties_as_new_ones_do) {
    // Points move between halves of a grid's cells: cocircular and collinear ones remain at every step.
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
        BOOST_REQUIRE((moving.edges() == delaunay(points).edges));
    }
    BOOST_TEST(followed > 200);
    BOOST_TEST(changed > 100);
}

BOOST_AUTO_TEST_CASE(new_points_of_a_grid_join_it_as_if_they_had_been_there) {
    // In any order: on edges, on the hull and on the lines along it, and always on a circle with others.
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Stream stream(seed, 0, 0, Purpose::sampling);
        std::vector<Vec2d> points;
        for (int x = 0; x < 6; ++x)
            for (int y = 0; y < 6; ++y) points.push_back({double(x), double(y)});
        for (std::size_t i = points.size() - 1; i > 0; --i)
            std::swap(points[i],
                      points[static_cast<std::size_t>(stream.uniform() * static_cast<double>(i + 1))]);
        MovingDelaunay moving;
        int followed = 0;
        for (std::size_t count = 3; count <= points.size(); ++count) {
            const std::span<const Vec2d> some(points.data(), count);
            const bool could = moving.follow(some);
            if (!could) moving.start(some);
            followed += could;
            const Triangulation renewed = delaunay(some);
            BOOST_REQUIRE((moving.edges() == renewed.edges));
            BOOST_REQUIRE((moving.triangles() == renewed.triangles));
        }
        BOOST_TEST(followed >= 30);
    }
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
        return moving.triangles() == delaunay(points).triangles;
    };
    BOOST_TEST(moved(1, {0.95, 1.05})); // a corner inwards, past the diagonal: the hull goes from 0 to 2 now
    BOOST_TEST(moved(4, {-0.5, 1}));    // the inner point out over an edge of the hull
}

BOOST_AUTO_TEST_CASE(a_triangulation_whose_hull_goes_round_twice_is_not_followed) {
    // Faces around the last point that now go round it twice: every face and every turn of the hull is valid.
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
    BOOST_TEST((!could || moving.triangles() == delaunay(wound).triangles));
}
