// SPDX-License-Identifier: MIT
// Self-collision (§2.5; decision 0007): a cell and a link push each other apart by a potential of the
// distance between them.
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// The point of the segment from a to b that is nearest to p.
template <class T> struct Foot {
    Vec2<T> point;
    T t; // 0 at a, 1 at b
};

template <class T> Foot<T> foot_on_segment(Vec2<T> p, Vec2<T> a, Vec2<T> b) {
    using std::max, std::min;
    const Vec2<T> edge = b - a;
    const T along = dot(p - a, edge) / max(squared_length(edge), T(1e-12));
    const T t = min(max(along, T(0)), T(1));
    return {a + edge * t, t};
}

/// The force on a cell at `from_foot` from the nearest point of a link: −∇U of U = stiffness/2·(radius − d)² for
/// d = |from_foot| < radius, nothing elsewhere nor at d = 0. U is continuous everywhere, so that whatever path a
/// cell takes, what contact gives it contact has taken.
template <class T> Vec2<T> contact_force(Vec2<T> from_foot, T stiffness, T radius) {
    const T d = length(from_foot);
    if (d == 0 || !(d < radius)) return {};
    return from_foot * (stiffness * (radius - d) / d);
}

} // namespace planula
