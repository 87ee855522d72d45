// SPDX-License-Identifier: MIT
#include "body/shape.h"

#include "base/math.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <vector>

using namespace planula;

namespace {

std::vector<Vec2d> line(int cells) {
    std::vector<Vec2d> positions;
    for (int i = 0; i < cells; ++i) positions.push_back({static_cast<double>(i), 0});
    return positions;
}

/// The lattice points within a circle.
std::vector<Vec2d> disc(double radius) {
    std::vector<Vec2d> positions;
    for (const Vec2d cell : specimens::lattice(61, 61).positions)
        if (length(cell - Vec2d{30.2, 26.1}) <= radius) positions.push_back(cell);
    return positions;
}

std::vector<Vec2d> moved(std::vector<Vec2d> cells, double angle, double scale, double mirror, Vec2d by) {
    const double c = math::cos(angle), s = math::sin(angle);
    for (Vec2d &cell : cells)
        cell = Vec2d{c * cell.x - s * cell.y, (s * cell.x + c * cell.y) * mirror} * scale + by;
    return cells;
}

double between(const std::vector<Vec2d> &a, const std::vector<Vec2d> &b) {
    return shape_distance(shape_distribution(a), shape_distribution(b));
}

} // namespace

BOOST_AUTO_TEST_CASE(a_line_has_the_distances_of_a_line) {
    // On a line of length 3 the mean distance is 1, and the share of pairs nearer than u is 1 - (1 - u/3)².
    const ShapeDistribution shape = shape_distribution(line(1000));
    for (int i = 0; i < shape_classes; ++i) {
        const double u = std::min((i + 1) * shape_reach / shape_classes, 3.0);
        const double expected = 1 - (1 - u / 3) * (1 - u / 3);
        BOOST_TEST(std::abs(shape[static_cast<std::size_t>(i)] - expected) < 0.003, i);
    }
}

BOOST_AUTO_TEST_CASE(equal_shapes_have_distance_0_and_line_and_disc_what_geometry_says) {
    BOOST_TEST(between(disc(6), disc(6)) == 0);
    // From 4 × 10^5 pairs drawn in a circle and the formula of the line: 0.208.
    BOOST_TEST(std::abs(between(line(400), disc(20)) - 0.208) < 0.005);
    BOOST_TEST(between(line(30), disc(3)) > 0.15);
}

BOOST_AUTO_TEST_CASE(place_orientation_size_and_mirror_do_not_matter) {
    // Only pairs on the border of a class may change it by rounding.
    for (const std::vector<Vec2d> &shape :
         {disc(4.3), specimens::two_arms(2).positions, specimens::hook().positions})
        for (const double angle : {0.0, 0.7, 2.9})
            for (const double mirror : {1.0, -1.0})
                BOOST_TEST(between(shape, moved(shape, angle, 3.7, mirror, {-40, 11})) < 0.004);
    // Discs of 15, 88 and 298 cells have nearly the same shape; the small one has few distances.
    BOOST_TEST(between(disc(2), disc(9)) < 0.12);
    BOOST_TEST(between(disc(5), disc(9)) < 0.03);
}

BOOST_AUTO_TEST_CASE(the_distance_is_a_metric_within_its_bounds) {
    std::vector<std::vector<Vec2d>> shapes{line(8),
                                           line(90),
                                           disc(2),
                                           disc(7),
                                           specimens::two_arms(3).positions,
                                           specimens::hook().positions,
                                           {{0, 0}, {1, 0}}};
    // A clump with one cell far away: pairs beyond the reach count in the last class.
    shapes.push_back(disc(4));
    shapes.back().push_back({1000, 0});
    for (const auto &a : shapes)
        for (const auto &b : shapes) {
            BOOST_TEST(between(a, b) == between(b, a));
            BOOST_TEST(between(a, b) <= shape_reach);
            BOOST_TEST((between(a, b) == 0) == (shape_distribution(a) == shape_distribution(b)));
            for (const auto &c : shapes) BOOST_TEST(between(a, c) <= between(a, b) + between(b, c) + 1e-6);
        }
}

BOOST_AUTO_TEST_CASE(a_shape_of_no_extent_is_no_error) {
    for (const std::vector<Vec2d> &cells :
         {std::vector<Vec2d>{}, std::vector<Vec2d>{{1, 2}}, std::vector<Vec2d>{{1, 2}, {1, 2}}})
        BOOST_TEST(shape_distribution(cells)[0] == 1);
}

BOOST_AUTO_TEST_CASE(diversity_is_the_mean_over_all_pairs) {
    const ShapeDistribution a = shape_distribution(line(20)), b = shape_distribution(disc(5));
    const double d = shape_distance(a, b);
    BOOST_TEST(shape_diversity({}) == 0);
    BOOST_TEST(shape_diversity(std::vector{a}) == 0);
    BOOST_TEST(shape_diversity(std::vector{a, a, a}) == 0);
    BOOST_TEST(shape_diversity(std::vector{a, b}) == d);
    BOOST_TEST(shape_diversity(std::vector{a, a, b, b}) == d * 4 / 6, boost::test_tools::tolerance(1e-12));
}
