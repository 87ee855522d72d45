// SPDX-License-Identifier: MIT
// Inelastic contact with the ground and exact Coulomb friction, by projected velocities (§2.5; decision 0010).
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// A straight piece of ground: a point of it and its unit normal, upwards.
template <class T> struct GroundPlane { Vec2<T> point, normal{0, 1}; };

/// How high above the ground a node would be at the end of the step.
template <class T>
T height_above(const GroundPlane<T> &ground, Vec2<T> position, Vec2<T> velocity, T time_step) {
    return dot(position - ground.point, ground.normal) + dot(velocity, ground.normal) * time_step;
}

/// The velocity after contact of a node that would be below the ground at the end of the step: the normal
/// part just brings it to the ground, the tangential part moves towards 0 by at most friction × that impulse.
template <class T>
Vec2<T> ground_contact(Vec2<T> position, Vec2<T> velocity, const GroundPlane<T> &ground, T friction,
                       T time_step) {
    using std::abs, std::max;
    const Vec2<T> along = right_normal(ground.normal);
    const T up = dot(velocity, ground.normal);
    const T gap = height_above(ground, position, velocity, time_step);
    const T impulse = -gap * (T(1) / time_step);
    const T sliding = dot(velocity, along), slowed = max(abs(sliding) - friction * impulse, T(0));
    const Vec2<T> touching = ground.normal * (up + impulse) + along * select(sliding < T(0), -slowed, slowed);
    return select(gap < T(0), touching, velocity);
}

} // namespace planula
