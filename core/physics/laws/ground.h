// SPDX-License-Identifier: MIT
// Inelastic contact with the ground and exact Coulomb friction, by projected velocities (§2.5; rule L3; decision 0010):
// with a plane, and with a polyline.
//
// What a node meets on a polyline is found along its whole way in a step, however narrow the pieces that it crosses. It
// is stopped by a piece's plane where it came from above that, so contact gives no energy. It is held a skin above the
// ground, wider than all rounding in single precision: what is above the ground in one step is above it in the next.
//
// The laws are templates on the number type, and on a line that tells its pieces by number, from left to right.
#pragma once

#include "base/vec2.h"

#include <algorithm>

namespace planula {

/// A straight piece of ground: a point of it and its unit normal, upwards.
template <class T> struct GroundPlane { Vec2<T> point, normal{0, 1}; };

/// How high above the ground a node would be at the end of the step.
template <class T>
PORTABLE T height_above(const GroundPlane<T> &ground, Vec2<T> position, Vec2<T> velocity, T time_step) {
    return dot(position - ground.point, ground.normal) + dot(velocity, ground.normal) * time_step;
}

/// The velocity after contact of a node that would be below the ground at the end of the step: the normal
/// part just brings it to the ground, the tangential part moves towards 0 by at most friction × that impulse.
template <class T>
PORTABLE Vec2<T> ground_contact(Vec2<T> position, Vec2<T> velocity, const GroundPlane<T> &ground, T friction,
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

/// A piece of a polyline between two points of it, the left one first. The first piece of a ground extends to x = −∞,
/// the last to x = +∞.
template <class T> struct Piece {
    Vec2<T> from, to;
    GroundPlane<T> plane;
};

/// The number of the piece below x: it begins at x or left of it, and ends right of it. The piece `guess` is looked at
/// first; then follows a search by halves.
template <class T, class Line> PORTABLE int piece_below(const Line &line, T x, int guess) {
    const auto &guessed = line[guess];
    if (!(x < T(guessed.from.x)) && x < T(guessed.to.x)) return guess;
    int low = 0, end = static_cast<int>(line.size());
    while (end - low > 1) {
        const int middle = low + (end - low) / 2;
        if (x < T(line[middle].from.x))
            end = middle;
        else
            low = middle;
    }
    return low;
}

template <class T, class Number> PORTABLE Vec2<T> as(Vec2<Number> v) { return {T(v.x), T(v.y)}; }

/// A distance above all rounding in single precision of a node's place.
template <class T> PORTABLE T rounding_at(Vec2<T> position) {
    using std::abs;
    return T(0x1p-20) * (T(1) + abs(position.x) + abs(position.y));
}

/// The plane that holds a node at `position` above a piece: a skin above the ground, or, where the node is nearer to
/// it, as high as the node is and a little more, for rounding.
template <class T> struct Hold {
    GroundPlane<T> plane;
    T slack; // an end of the way so much lower counts as above

    template <class Number>
    PORTABLE Hold(const Piece<Number> &piece, Vec2<T> position)
        : plane{as<T>(piece.plane.point), as<T>(piece.plane.normal)} {
        using std::min;
        const T rounding = rounding_at(position), skin = T(8) * rounding;
        const T height = dot(position - plane.point, plane.normal);
        plane.point += plane.normal * min(skin, height + rounding);
        slack = T(0.5) * rounding;
    }
    PORTABLE bool lets(Vec2<T> end) const { return !(dot(end - plane.point, plane.normal) < -slack); }
};

/// The first piece that a node meets on its straight way from `start`, which is above piece `below`, to `end`; -1 if
/// there is none. It meets a piece whose far point lies above its way, or whose plane does not let it end there.
template <class T, class Line>
PORTABLE int piece_met(const Line &line, int below, Vec2<T> start, Vec2<T> end) {
    const Vec2<T> way = end - start;
    const bool right = T(0) < way.x;
    const int last = static_cast<int>(line.size()) - 1;
    for (int i = below;; i += right ? 1 : -1) {
        const auto &piece = line[i];
        const bool passes = right ? i < last && !(end.x < T(piece.to.x)) : i > 0 && end.x < T(piece.from.x);
        if (!passes) return Hold<T>(piece, start).lets(end) ? -1 : i;
        const T above = cross(way, as<T>(right ? piece.to : piece.from) - start);
        if (right ? T(0) < above : above < T(0)) return i;
    }
}

/// The velocity after contact of a node, which is above piece `below`, with whatever it meets on its way in a step:
/// with one piece after another, as in a valley, and 0 if four contacts do not let it go on.
template <class T, class Line>
PORTABLE Vec2<T> contact_on_way(const Line &line, int below, Vec2<T> position, Vec2<T> velocity, T friction,
                                T time_step) {
    constexpr int most_contacts = 4;
    for (int contacts = 0;; ++contacts) {
        const int met = piece_met(line, below, position, position + velocity * time_step);
        if (met < 0) return velocity;
        if (contacts == most_contacts) return {T(0), T(0)};
        velocity =
            ground_contact(position, velocity, Hold<T>(line[met], position).plane, friction, time_step);
    }
}

} // namespace planula
