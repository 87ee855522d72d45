// SPDX-License-Identifier: MIT
// How a body is shaped, as numbers that can be compared: the shape distribution D2 of Osada, Funkhouser,
// Chazelle and Dobkin (2002), "Shape distributions", ACM Transactions on Graphics 21(4), 807–832. It is the
// distribution of the distances between two points of a shape. Here the points are the cell centres, every pair
// counts, and distances are in units of their mean. So a shape's size, place and orientation do not matter, nor
// does a mirror. Two shapes are compared by the area between their cumulative distributions (there: CDF L1),
// which is also the earth mover's distance of the histograms. It costs about 20 µs for a body of 110 cells.
#pragma once

#include "base/vec2.h"

#include <array>
#include <span>

namespace planula {

/// Classes of distance up to four times the mean; a full line reaches three. Longer ones count in the last.
inline constexpr int shape_classes = 64;
inline constexpr double shape_reach = 4;

/// Entry i: the share of all pairs whose distance is below (i + 1) / shape_classes of the reach. All 1 for
/// fewer than two different points.
using ShapeDistribution = std::array<float, shape_classes>;

ShapeDistribution shape_distribution(std::span<const Vec2d> cells);

/// The morphological distance of two shapes, in mean distances: 0 for equal ones, at most shape_reach; about
/// 0.2 between a line and a disc.
double shape_distance(const ShapeDistribution &a, const ShapeDistribution &b);

/// The mean distance over all pairs of these shapes: how diverse they are; 0 for fewer than two.
double shape_diversity(std::span<const ShapeDistribution> shapes);

} // namespace planula
