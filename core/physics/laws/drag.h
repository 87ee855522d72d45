// SPDX-License-Identifier: MIT
// Fluid drag on an edge of the outline, tangential and normal part (§2.5; form after Sfakiotakis & Tsakiris
// 2006).
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// The force on a straight edge that moves with `velocity` through the fluid: −λ_T ℓ v_T|v_T| along it and
/// −λ_N ℓ v_N|v_N| across it, ℓ its length.
template <class T> PORTABLE Vec2<T> drag_force(Vec2<T> edge, Vec2<T> velocity, T normal, T tangential) {
    using std::abs, std::max, std::sqrt;
    const T l = sqrt(max(squared_length(edge), T(1e-12)));
    const Vec2<T> along = edge * (T(1) / l), across = right_normal(along);
    const T v_along = dot(velocity, along), v_across = dot(velocity, across);
    return along * (-(tangential * l) * v_along * abs(v_along)) +
           across * (-(normal * l) * v_across * abs(v_across));
}

} // namespace planula
