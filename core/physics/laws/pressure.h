// SPDX-License-Identifier: MIT
// The hydrostatic skeleton: pressure in a triangle grows as it is compressed (§2.5; MODEL B2).
#pragma once

#include "base/vec2.h"

namespace planula {

template <class T> struct CornerForces { Vec2<T> a, b, c; };

/// The forces on the corners of a counter-clockwise triangle: p ∂A/∂x with p = stiffness·(A0 − A) and A the
/// signed area, so that an inverted triangle is pushed back too. `stiffness` is kp / max(A0, area_floor).
template <class T>
CornerForces<T> pressure_forces(Vec2<T> a, Vec2<T> b, Vec2<T> c, T equilibrium_area, T stiffness) {
    const Vec2<T> ab = b - a, ac = c - a;
    const T area = T(0.5) * cross(ab, ac);
    const T half_pressure = T(0.5) * stiffness * (equilibrium_area - area);
    return {right_normal(ab - ac) * half_pressure, right_normal(ac) * half_pressure,
            right_normal(-ab) * half_pressure};
}

} // namespace planula
