// SPDX-License-Identifier: MIT
// The hydrostatic skeleton: pressure in a triangle grows as it is compressed (§2.5; decision 0006).
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// Half the pressure of a triangle as a function of its signed area A: p/2 = slope·(2A0 − 2A).
template <class T> struct Pressure { T twice_area = 0, slope = 0; };

/// p = kp (A0 − A) / max(A0, floor), from A0, kp and the floor.
template <class T>
PORTABLE Pressure<T> pressure_of(double equilibrium_area, double stiffness, double area_floor) {
    return {static_cast<T>(2 * equilibrium_area),
            static_cast<T>(0.25 * stiffness / std::max(equilibrium_area, area_floor))};
}

/// The force on one corner of a triangle, p ∂A/∂x, whose other corners lie at `first` and `second` from it,
/// counter-clockwise. The area is signed, so that an inverted triangle is pushed back too.
template <class T>
PORTABLE Vec2<T> pressure_force(Vec2<T> first, Vec2<T> second, const Pressure<T> &pressure) {
    const T half_pressure = pressure.slope * (pressure.twice_area - cross(first, second));
    return right_normal(first - second) * half_pressure;
}

} // namespace planula
