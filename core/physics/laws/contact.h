// SPDX-License-Identifier: MIT
// Self-collision (§2.5; MODEL B3): a cell on the outline is pushed along the signed distance φ to the nearest
// unmasked link of it, φ > 0 outside the body.
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

/// The force on a cell at `from_foot` from the nearest point of a link: stiffness·(radius − φ) along ∇φ for
/// −depth < φ < radius, nothing elsewhere nor at φ = 0.
template <class T> Vec2<T> contact_force(Vec2<T> from_foot, bool outside, T stiffness, T radius, T depth) {
    const T d = length(from_foot);
    const T phi = outside ? d : -d;
    if (d == 0 || !(phi > -depth && phi < radius)) return {};
    const Vec2<T> up = from_foot / phi;
    return up * (stiffness * (radius - phi));
}

} // namespace planula
