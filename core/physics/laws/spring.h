// SPDX-License-Identifier: MIT
// Hooke's law with damping (§2.5; MODEL B1). A law is one template on the number type.
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// The force on the first end of a spring, the second lying at `offset` and moving with `velocity` relative
/// to it: k(l − L) + c·dl/dt along the spring.
template <class T> Vec2<T> spring_force(Vec2<T> offset, Vec2<T> velocity, T rest, T stiffness, T damping) {
    const T l = std::sqrt(std::max(squared_length(offset), T(1e-12)));
    const Vec2<T> along = offset / l;
    return along * (stiffness * (l - rest) + damping * dot(velocity, along));
}

} // namespace planula
