// SPDX-License-Identifier: MIT
#include "physics/object.h"

#include "base/error.h"
#include "base/text.h"
#include "physics/laws/contact.h"
#include "physics/room.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace planula {

namespace {

constexpr double row_height = 0.8660254037844386, rounding = 1e-9;
constexpr int most_cells = 500;

[[noreturn]] void refuse(const std::string &rule, double value) {
    throw InputError("environment: an object " + rule + ", not " + to_text(value));
}

/// The body of the cells of the lattice, no farther from its middle than `extent`, that `has` takes.
Body lattice_of(Vec2d at, double extent, const std::function<bool(Vec2d)> &has) {
    if (!(extent <= most_cells)) refuse("may reach 500 cells from its place", extent);
    const int rows = static_cast<int>(extent / row_height) + 1, columns = static_cast<int>(2 * extent) + 2;
    std::vector<Vec2d> cells;
    for (int row = -rows; row <= rows; ++row)
        for (int column = -columns; column <= columns; ++column) {
            const Vec2d place{column + 0.5 * (row & 1), row * row_height};
            if (has(place)) cells.push_back(at + place);
        }
    return make_object(cells);
}

} // namespace

Body make_object(const std::vector<Vec2d> &cells) {
    if (cells.size() < 3 || cells.size() > most_cells)
        refuse("needs 3 … 500 cells, which lie a cell apart", static_cast<double>(cells.size()));
    const Body body = make_body(cells, 1.2);
    std::vector<char> in_triangle(cells.size());
    for (const auto &[a, b, c] : body.mesh.triangles) in_triangle[a] = in_triangle[b] = in_triangle[c] = 1;
    const auto loose = std::count(in_triangle.begin(), in_triangle.end(), 0);
    if (loose > 0)
        refuse("must be two cells wide or more everywhere: 0 cells outside triangles",
               static_cast<double>(loose));
    const double longest = *std::max_element(body.rest_lengths.begin(), body.rest_lengths.end());
    if (longest > 1.2) refuse("must hold together: its cells 1 apart", longest);
    return body;
}

Body make_object(Vec2d at, const std::vector<Vec2d> &shape) {
    double extent = 0;
    for (const Vec2d point : shape) extent = std::max(extent, length(point));
    return lattice_of(at, extent, [&](Vec2d place) {
        bool touches = false;
        for (std::size_t i = 0; i < shape.size(); ++i) {
            const Vec2d foot = foot_on_segment(place, shape[i], shape[(i + 1) % shape.size()]).point;
            touches = touches || length(place - foot) < rounding;
        }
        return touches || is_inside(place, shape);
    });
}

Body make_object(Vec2d at, double radius) {
    return lattice_of(at, radius, [&](Vec2d place) { return length(place) <= radius + rounding; });
}

} // namespace planula
