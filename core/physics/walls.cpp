// SPDX-License-Identifier: MIT
#include "physics/walls.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planula {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double far = 1e10; // stands for infinity where a point is needed

bool is_near(Vec2d point) { return std::abs(point.x) < far / 2; }

/// Points joined by walls, the free side on the right.
struct Line {
    std::vector<Vec2d> points;
    std::vector<double>
        frictions; // of the walls; of an open line also of the level ones before and after the points
    bool closed = false, leftwards = false, pierces = true;
};

bool is_clockwise(std::span<const Vec2d> polygon) {
    double twice_area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice_area += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
    return twice_area < 0;
}

Line line_of(const Obstacle &obstacle, const Environment &environment) {
    Line line{.points = obstacle.points, .closed = true};
    if (is_clockwise(line.points)) std::reverse(line.points.begin(), line.points.end());
    line.frictions.assign(line.points.size(), obstacle.friction.value_or(environment.friction));
    return line;
}

std::vector<Line> lines_of(const Environment &environment) {
    std::vector<Line> lines;
    if (!environment.has_walls()) return lines;
    if (environment.has_ground) { // free above, thus from right to left
        auto [points, frictions] = cut(environment.ground, environment);
        std::reverse(points.begin(), points.end()), std::reverse(frictions.begin(), frictions.end());
        lines.push_back({std::move(points), std::move(frictions), false, true, false});
    }
    if (!environment.ceiling.empty()) {
        auto [points, frictions] = cut(environment.ceiling, environment);
        lines.push_back({std::move(points), std::move(frictions)});
    }
    for (const Obstacle &obstacle : environment.obstacles) lines.push_back(line_of(obstacle, environment));
    return lines;
}

template <class T> Vec2<T> rounded_to(Vec2d v) { return {static_cast<T>(v.x), static_cast<T>(v.y)}; }

/// Counted from the origin, as they are in T. Different points may become equal; of these the first stays.
template <class T> Line rounded(const Line &line, Vec2d origin) {
    Line result{.closed = line.closed, .leftwards = line.leftwards, .pierces = line.pierces};
    const std::size_t before = line.closed ? 0 : 1; // walls before the first point
    if (before) result.frictions.push_back(line.frictions.front());
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec2<T> point = rounded_to<T>(line.points[i] - origin);
        const Vec2d exact{point.x, point.y};
        const double friction = line.frictions[i + before];
        if (!result.points.empty() && result.points.back() == exact)
            result.frictions.back() = friction;
        else
            result.points.push_back(exact), result.frictions.push_back(friction);
    }
    while (line.closed && result.points.size() > 1 && result.points.back() == result.points.front())
        result.points.pop_back(), result.frictions.pop_back();
    return result;
}

template <class T> Wall<T> wall_between(Vec2d first, Vec2d last, double friction, bool pierces) {
    const Vec2d along = (last - first) / length(last - first);
    // Counted from the end that is near.
    const Vec2d base = is_near(first) ? first : last, point = base - along * dot(base, along);
    return {rounded_to<T>(point),
            rounded_to<T>(along),
            static_cast<T>(is_near(first) ? dot(first - point, along) : -infinity),
            static_cast<T>(is_near(last) ? dot(last - point, along) : infinity),
            rounded_to<T>(first),
            rounded_to<T>(last),
            static_cast<T>(friction),
            -1,
            pierces};
}

template <class T> void add_walls(const Line &line, std::vector<Wall<T>> &walls) {
    std::vector<Vec2d> points = line.points;
    if (line.closed) {
        points.push_back(points.front());
    } else { // level beyond the ends
        const double ahead = line.leftwards ? -far : far;
        points.insert(points.begin(), {-ahead, points.front().y});
        points.push_back({ahead, points.back().y});
    }
    const int first = static_cast<int>(walls.size());
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        walls.push_back(wall_between<T>(points[i], points[i + 1], line.frictions[i], line.pierces));
        walls.back().next = static_cast<int>(walls.size());
    }
    walls.back().next = line.closed ? first : -1;
}

/// The friction at x.
double friction_at(double x, const Environment &environment) {
    for (const auto &[from, to, friction] : environment.friction_patches)
        if (from <= x && x < to) return friction;
    return environment.friction;
}

} // namespace

CutLine cut(const std::vector<Vec2d> &line, const Environment &environment) {
    CutLine result{.points = line};
    const auto by_x = [](Vec2d a, Vec2d b) { return a.x < b.x; };
    for (const FrictionPatch &patch : environment.friction_patches)
        for (const double x : {patch.from, patch.to}) {
            const Vec2d point{x, height_of(line, x)};
            auto &points = result.points;
            const auto at = std::lower_bound(points.begin(), points.end(), point, by_x);
            if (at == points.end() || at->x != x) points.insert(at, point);
        }
    if (result.points.empty()) result.points.push_back({0, 0});
    result.frictions.push_back(friction_at(-infinity, environment));
    for (const Vec2d point : result.points) result.frictions.push_back(friction_at(point.x, environment));
    return result;
}

template <class T> Walls<T>::Walls(const Environment &environment, Vec2d origin) {
    for (const Line &line : lines_of(environment)) {
        const Line as_in_T = rounded<T>(line, origin);
        if (!as_in_T.closed || as_in_T.points.size() > 1) add_walls(as_in_T, walls_);
    }
    if (!walls_.empty()) make_grid();
}

/// Squares of a cell or more, some four for each wall.
template <class T> void Walls<T>::make_grid() {
    Vec2d low{infinity, infinity}, high{-infinity, -infinity};
    for (const Wall<T> &wall : walls_)
        for (const Vec2<T> end : {wall.first, wall.last}) {
            const Vec2d point{end.x, end.y};
            if (!is_near(point)) continue;
            low = {std::min(low.x, point.x), std::min(low.y, point.y)};
            high = {std::max(high.x, point.x), std::max(high.y, point.y)};
        }
    const Vec2d size = high - low;
    const double most = 4 * static_cast<double>(walls_.size()) + 16;
    side_ = std::max({1.0, std::sqrt(size.x * size.y / most), size.x / most, size.y / most});
    low_ = rounded_to<T>(low), per_square_ = static_cast<T>(1 / side_);
    columns_ = static_cast<int>(size.x / side_) + 1, rows_ = static_cast<int>(size.y / side_) + 1;

    Squares squares(static_cast<std::size_t>(columns_) * rows_);
    // Above all rounding of places in T.
    const double margin = 1e-3 * side_ + 1e-5 * (std::abs(low.x) + std::abs(low.y) + size.x + size.y);
    for (std::size_t i = 0; i < walls_.size(); ++i) add_to(squares, static_cast<int>(i), margin);
    first_.assign(1, 0), members_.clear();
    for (const auto &square : squares) {
        members_.insert(members_.end(), square.begin(), square.end());
        first_.push_back(static_cast<int>(members_.size()));
    }
}

/// Enters a wall into the squares that it comes into, column by column.
template <class T> void Walls<T>::add_to(Squares &squares, int number, double margin) const {
    Vec2d a{walls_[number].first.x, walls_[number].first.y}, b{walls_[number].last.x, walls_[number].last.y};
    if (b.x < a.x) std::swap(a, b);
    const auto column_at = [&](double x) {
        return square_at(static_cast<T>(x), low_.x, per_square_, columns_);
    };
    const auto row_at = [&](double y) { return square_at(static_cast<T>(y), low_.y, per_square_, rows_); };
    const auto height = [&](double x) {
        return a.y + (b.y - a.y) * ((std::clamp(x, a.x, b.x) - a.x) / (b.x - a.x));
    };
    const bool upright = b.x - a.x < 2 * margin;
    for (int column = column_at(a.x - margin); column <= column_at(b.x + margin); ++column) {
        const double left = column == 0 ? -infinity : low_.x + column * side_ - margin;
        const double right = column + 1 == columns_ ? infinity : low_.x + (column + 1) * side_ + margin;
        const double one = upright ? a.y : height(left), other = upright ? b.y : height(right);
        const int top = row_at(std::max(one, other) + margin);
        for (int row = row_at(std::min(one, other) - margin); row <= top; ++row)
            squares[static_cast<std::size_t>(row) * columns_ + column].push_back(number);
    }
}

template class Walls<float>;
template class Walls<double>;

} // namespace planula
