// SPDX-License-Identifier: MIT
// Hooke's law with damping, and the muscles that change its rest length (§2.5, 2.6; decision 0006). A law
// is one template on the number type: a number, or several side by side (base/lanes.h).
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// The force on the first end of a spring, the second lying at `offset` and moving with `velocity` relative
/// to it: k(l − L) + c·dl/dt along the spring, with stiffness k, `stiffness_rest` k·L and damping c.
template <class T>
Vec2<T> spring_force(Vec2<T> offset, Vec2<T> velocity, T stiffness, T stiffness_rest, T damping) {
    using std::max, std::sqrt;
    const T per_length = T(1) / sqrt(max(squared_length(offset), T(1e-12)));
    const T slowing = damping * (dot(velocity, offset) * per_length);
    return offset * (stiffness + (slowing - stiffness_rest) * per_length);
}

/// The rest length of a spring between two nodes whose muscles lengthen what they hold by these shares: L =
/// (1 + e1 + e2) L0, the form of Eqs. (1) and (3). With k·L0 for L0 it gives k·L.
template <class T> T actuated_length(T L0, T e1, T e2) { return (T(1) + (e1 + e2)) * L0; }

} // namespace planula
