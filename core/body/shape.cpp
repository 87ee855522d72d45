// SPDX-License-Identifier: MIT
#include "body/shape.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace planula {

namespace {

/// The distance of every pair.
std::vector<double> distances(std::span<const Vec2d> cells) {
    if (cells.empty()) return {};
    std::vector<double> found(cells.size() * (cells.size() - 1) / 2);
    double *pair = found.data();
    for (std::size_t a = 0; a < cells.size(); ++a)
        for (std::size_t b = a + 1; b < cells.size(); ++b) *pair++ = length(cells[b] - cells[a]);
    return found;
}

} // namespace

ShapeDistribution shape_distribution(std::span<const Vec2d> cells) {
    const std::vector<double> pairs = distances(cells);
    double sum = 0;
    for (const double distance : pairs) sum += distance;
    ShapeDistribution shape;
    shape.fill(1);
    if (!(sum > 0) || !std::isfinite(sum)) return shape;

    // Count the pairs of each class, then add the classes up.
    const double scale = static_cast<double>(pairs.size()) / sum * (shape_classes / shape_reach);
    std::array<int, shape_classes> counts{};
    for (const double distance : pairs)
        ++counts[static_cast<std::size_t>(static_cast<int>(std::min(distance * scale, shape_classes - 1.0)))];
    int below = 0;
    for (std::size_t i = 0; i < shape.size(); ++i) {
        below += counts[i];
        shape[i] = static_cast<float>(static_cast<double>(below) / static_cast<double>(pairs.size()));
    }
    return shape;
}

double shape_distance(const ShapeDistribution &a, const ShapeDistribution &b) {
    float area = 0;
    for (std::size_t i = 0; i < a.size(); ++i) area += std::abs(a[i] - b[i]);
    return static_cast<double>(area) * (shape_reach / shape_classes);
}

double shape_diversity(std::span<const ShapeDistribution> shapes) {
    double sum = 0;
    for (std::size_t a = 0; a < shapes.size(); ++a)
        for (std::size_t b = a + 1; b < shapes.size(); ++b) sum += shape_distance(shapes[a], shapes[b]);
    const double pairs = static_cast<double>(shapes.size()) * (static_cast<double>(shapes.size()) - 1) / 2;
    return pairs > 0 ? sum / pairs : 0;
}

} // namespace planula
