// SPDX-License-Identifier: MIT
#include "evolution/nearest_neighbours.h"

#include "base/error.h"
#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <limits>
#include <vector>

using namespace planula;

namespace {

using Point = std::vector<double>;

/// What the index must find: all points sorted.
std::vector<Neighbour> by_sorting(const std::vector<Point> &points, const Point &place, std::size_t k) {
    std::vector<Neighbour> all;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double sum = 0;
        for (std::size_t d = 0; d < place.size(); ++d)
            sum += (place[d] - points[i][d]) * (place[d] - points[i][d]);
        all.push_back({sum, i});
    }
    std::sort(all.begin(), all.end());
    all.resize(std::min(k, all.size()));
    return all;
}

std::vector<Neighbour> nearest(const PointIndex &index, const Point &place, int k) {
    NearestNeighbours result(k);
    index.offer(place, 0, result);
    return result.list();
}

/// Clouds of many kinds: even, on a coarse lattice full of ties and duplicates, on a line, in clusters far
/// from the origin, and of sizes from 1e-160 to 1e100.
Point random_point(int kind, std::size_t dimensions, Stream &stream) {
    Point point(dimensions);
    const double cluster = static_cast<double>(stream.below(3));
    for (double &x : point) {
        const double u = stream.triangular();
        const double power = stream.triangular();
        x = kind == 0   ? 40 * u
            : kind == 1 ? static_cast<double>(stream.below(4))
            : kind == 2 ? (&x == point.data() ? u : 7)
            : kind == 3 ? 1e6 * cluster + 1e-3 * u
                        : (power < 0     ? 1e-160
                           : power < 0.5 ? 1
                                         : 1e100) *
                              u;
    }
    return point;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_index_finds_what_sorting_all_points_finds_to_the_bit) {
    // 5 kinds of cloud × 5 dimensions × 600 points, asked 4 times after each 3: 20 000 questions.
    int questions = 0;
    for (int kind = 0; kind < 5; ++kind)
        for (const std::size_t dimensions : {1u, 2u, 3u, 5u, 16u}) {
            Stream stream = specimens::stream(static_cast<std::uint32_t>(kind * 100 + dimensions));
            PointIndex index;
            std::vector<Point> points;
            while (points.size() < 600) {
                points.push_back(random_point(kind, dimensions, stream));
                index.add(points.back());
                if (points.size() % 3 != 0) continue;
                for (int k : {1, 2, 15, 1000}) {
                    // Sometimes the place is a point of the cloud.
                    const auto known = stream.below(static_cast<std::uint32_t>(points.size()));
                    const Point elsewhere = random_point(kind, dimensions, stream);
                    const Point &place = stream.chance(0.5) ? points[known] : elsewhere;
                    const auto found = nearest(index, place, k);
                    BOOST_REQUIRE((found == by_sorting(points, place, static_cast<std::size_t>(k))));
                    ++questions;
                }
            }
        }
    BOOST_TEST(questions == 20000);
}

BOOST_AUTO_TEST_CASE(among_equally_near_points_the_first_added_is_the_nearer) {
    PointIndex index;
    for (int i = 0; i < 500; ++i) index.add(Point{1, 1});
    const auto found = nearest(index, {1, 2}, 3);
    BOOST_REQUIRE(found.size() == 3u);
    for (std::size_t i = 0; i < 3; ++i) {
        BOOST_TEST(found[i].index == i);
        BOOST_TEST(found[i].squared == 1);
    }
}

BOOST_AUTO_TEST_CASE(others_may_be_offered_beside_the_index) {
    PointIndex index;
    index.add(Point{0});
    index.add(Point{5});
    NearestNeighbours nearest(2);
    nearest.offer({4, 0});
    nearest.offer({1, 1});
    index.offer(Point{0.5}, 10, nearest);
    BOOST_REQUIRE(nearest.list().size() == 2u);
    BOOST_TEST((nearest.list()[0] == Neighbour{0.25, 10}));
    BOOST_TEST((nearest.list()[1] == Neighbour{1, 1}));
}

BOOST_AUTO_TEST_CASE(an_empty_index_has_no_neighbours_and_lengths_must_agree) {
    PointIndex index;
    BOOST_TEST(index.size() == 0u);
    BOOST_TEST(nearest(index, {1, 2}, 5).empty());
    BOOST_CHECK_THROW(index.add(Point{}), InternalError);
    index.add(Point{1, 2});
    BOOST_CHECK_THROW(index.add(Point{1}), InternalError);
    BOOST_CHECK_THROW(nearest(index, {1}, 5), InternalError);
}
