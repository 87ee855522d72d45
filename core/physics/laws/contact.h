// SPDX-License-Identifier: MIT
// Self-collision: a cell and a link push each other apart by a potential of the distance between them (§2.5; rule B5;
// decision 0007).
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// The point of the segment from a to b that is nearest to p.
template <class T> struct Foot {
    Vec2<T> point;
    T t; // 0 at a, 1 at b
};

template <class T> PORTABLE Foot<T> foot_on_segment(Vec2<T> p, Vec2<T> a, Vec2<T> b) {
    using std::max, std::min;
    const Vec2<T> edge = b - a;
    const T along = dot(p - a, edge) / max(squared_length(edge), T(1e-12));
    const T t = min(max(along, T(0)), T(1));
    return {a + edge * t, t};
}

/// The force on a cell at `from_foot` from the nearest point of a link: −∇U of U = stiffness/2·(radius − d)² for
/// d = |from_foot| < radius, and 0 elsewhere and at d = 0. U is continuous everywhere, so contact gives no more
/// energy than it took, whatever path a cell takes.
template <class T> PORTABLE Vec2<T> contact_force(Vec2<T> from_foot, T stiffness, T radius) {
    const T d = length(from_foot);
    if (d == 0 || !(d < radius)) return {};
    return from_foot * (stiffness * (radius - d) / d);
}

/// The forces of a contact on the cell and on the link's ends a and b.
template <class T> struct ContactForces { Vec2<T> on_cell, on_a, on_b; };

/// Those between a cell and the link from a to b; the link takes the opposite force by the lever of the foot.
template <class T>
PORTABLE ContactForces<T> contact_forces(Vec2<T> cell, Vec2<T> a, Vec2<T> b, T stiffness, T radius) {
    const auto foot = foot_on_segment(cell, a, b);
    const Vec2<T> force = contact_force(cell - foot.point, stiffness, radius);
    return {force, -force * (1 - foot.t), -force * foot.t};
}

} // namespace planula
