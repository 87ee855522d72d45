// SPDX-License-Identifier: MIT
// The ground in the native engine: a plane, or the pieces of a polyline (§2.5; decision 0010).
//
// What a node meets on a polyline is found along its whole way in a step, however narrow the pieces that it crosses. It
// is stopped by a piece's plane where it came from above that, so contact gives no energy. It is held a skin above the
// ground, wider than all rounding: what is above the ground in one step is above it in the next.
//
// The rules are templates on the number type, and on a line that tells its pieces by number, from left to right.
#pragma once

#include "physics/environment.h"
#include "physics/laws/ground.h"

#include <vector>

namespace planula::native {

/// A straight piece of ground between two points of it, the left one first. The first piece of a ground reaches to the
/// left for ever, the last to the right.
struct Piece {
    Vec2f from, to;
    GroundPlane<float> plane;
};

/// The pieces of an environment's ground as seen from `origin`, from left to right: each begins where the one before
/// ends, and may be upright. None without ground, one if it is level everywhere.
std::vector<Piece> lay_ground(const Environment &environment, Vec2d origin);

/// The number of the piece below x: it begins at x or left of it, and ends right of it. It is looked for at `guess`
/// first, then by halves.
template <class T, class Line> int piece_below(const Line &line, T x, int guess) {
    const Piece &guessed = line[guess];
    if (!(x < T(guessed.from.x)) && x < T(guessed.to.x)) return guess;
    int low = 0, end = line.size();
    while (end - low > 1) {
        const int middle = low + (end - low) / 2;
        if (x < T(line[middle].from.x))
            end = middle;
        else
            low = middle;
    }
    return low;
}

template <class T> Vec2<T> as(Vec2f v) { return {T(v.x), T(v.y)}; }

/// The plane that holds a node at `position` above a piece: a skin above the ground, or, where the node is nearer to
/// it, so high as it is and a little more, for rounding.
template <class T> struct Hold {
    GroundPlane<T> plane;
    T slack; // so much lower is as good

    Hold(const Piece &piece, Vec2<T> position) : plane{as<T>(piece.plane.point), as<T>(piece.plane.normal)} {
        using std::abs, std::min;
        const T rounding = T(0x1p-20) * (T(1) + abs(position.x) + abs(position.y)), skin = T(8) * rounding;
        const T height = dot(position - plane.point, plane.normal);
        plane.point += plane.normal * min(skin, height + rounding);
        slack = T(0.5) * rounding;
    }
    bool lets(Vec2<T> end) const { return !(dot(end - plane.point, plane.normal) < -slack); }
};

/// The first piece that a node meets on its straight way from `start`, which is above piece `below`, to `end`; -1 if
/// none. It meets a piece whose far point lies above its way, or whose plane does not let it end where it does.
template <class T, class Line> int piece_met(const Line &line, int below, Vec2<T> start, Vec2<T> end) {
    const Vec2<T> way = end - start;
    const bool right = T(0) < way.x;
    const int last = line.size() - 1;
    for (int i = below;; i += right ? 1 : -1) {
        const Piece &piece = line[i];
        const bool passes = right ? i < last && !(end.x < T(piece.to.x)) : i > 0 && end.x < T(piece.from.x);
        if (!passes) return Hold<T>(piece, start).lets(end) ? -1 : i;
        const T above = cross(way, as<T>(right ? piece.to : piece.from) - start);
        if (right ? T(0) < above : above < T(0)) return i;
    }
}

/// The velocity of a node after contact with whatever it meets on its way in a step: of one piece after another, as
/// in a valley, and none if that does not let it go on. The node is above piece `below`.
template <class T, class Line>
Vec2<T> contact_on_way(const Line &line, int below, Vec2<T> position, Vec2<T> velocity, T friction,
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

} // namespace planula::native
