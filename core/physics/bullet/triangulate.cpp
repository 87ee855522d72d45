// SPDX-License-Identifier: MIT
#include "physics/bullet/triangulate.h"

#include <algorithm>

namespace planula {

namespace {

double twice_area(Vec2d a, Vec2d b, Vec2d c) { return cross(b - a, c - a); }

/// Whether a corner can be cut off: it points outwards and no other point is in the way.
bool is_ear(const std::vector<Vec2d> &polygon, std::size_t i) {
    const std::size_t count = polygon.size();
    const Vec2d a = polygon[(i + count - 1) % count], b = polygon[i], c = polygon[(i + 1) % count];
    if (!(twice_area(a, b, c) > 0)) return false;
    return std::none_of(polygon.begin(), polygon.end(), [&](Vec2d p) {
        return p != a && p != b && p != c && twice_area(a, b, p) >= 0 && twice_area(b, c, p) >= 0 &&
               twice_area(c, a, p) >= 0;
    });
}

} // namespace

std::vector<std::array<Vec2d, 3>> triangulate(std::vector<Vec2d> polygon) {
    double area = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        area += twice_area(polygon[0], polygon[i - 1], polygon[i]);
    if (area < 0) std::reverse(polygon.begin(), polygon.end());

    std::vector<std::array<Vec2d, 3>> triangles;
    while (polygon.size() > 2) {
        const std::size_t count = polygon.size();
        std::size_t ear = 0;
        while (ear + 1 < count && !is_ear(polygon, ear)) ++ear;
        const Vec2d a = polygon[(ear + count - 1) % count], b = polygon[ear], c = polygon[(ear + 1) % count];
        if (twice_area(a, b, c) > 0) triangles.push_back({a, b, c}); // points on one line leave none
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    return triangles;
}

} // namespace planula
