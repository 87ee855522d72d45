// SPDX-License-Identifier: MIT
// Hooke's law with damping, and the muscles that change its rest length (§2.5, 2.6; decision 0006). A law
// is one template on the number type: a number, or several side by side (base/lanes.h).
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// A spring as its first end sees it: the offset of the second, its velocity times that, and 1/length.
template <class T> struct Spring {
    Vec2<T> offset;
    T departing, per_length;
};

/// The second end lying at `offset` and moving with `velocity` relative to the first.
template <class T> PORTABLE Spring<T> spring_to(Vec2<T> offset, Vec2<T> velocity) {
    using std::max, std::sqrt;
    const T per_length = T(1) / sqrt(max(squared_length(offset), T(1e-12)));
    return {offset, dot(velocity, offset), per_length};
}

/// The force on the first end: k(l − L) + c·dl/dt along the spring, with stiffness k, `stiffness_rest` k·L and
/// damping c.
template <class T>
PORTABLE Vec2<T> spring_force(const Spring<T> &spring, T stiffness, T stiffness_rest, T damping) {
    const T slowing = damping * (spring.departing * spring.per_length);
    return spring.offset * (stiffness + (slowing - stiffness_rest) * spring.per_length);
}

/// The rest length of a spring between two nodes whose muscles lengthen what they hold by these shares: L =
/// (1 + e1 + e2) L0, the form of Eqs. (1) and (3). With k·L0 for L0 it gives k·L.
template <class T> PORTABLE T actuated_length(T L0, T e1, T e2) { return (T(1) + (e1 + e2)) * L0; }

} // namespace planula
