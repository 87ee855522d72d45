// SPDX-License-Identifier: MIT
// Contact with walls: the sides of obstacles, and ground and ceiling beside them (decision 0024). Walls have no side of
// their own: a node stays on the side from which it comes. It is held a skin away from a wall, also from its ends, as
// the laws of the ground do it (laws/ground.h), and never comes nearer, so that it passes no wall however thin, and
// contact gives no energy. Between two nodes a corner could enter the body through a link of the outline; there a
// potential draws the link back (pull_back()).
//
// The laws are templates on the number type.
#pragma once

#include "physics/laws/contact.h"
#include "physics/laws/ground.h"

#include <algorithm>

namespace planula {

/// A straight wall. Lines of walls run with the free side on their right.
template <class Number> struct Wall {
    Vec2<Number> point, along; // of its line: the point nearest to the origin, and the unit direction
    Number from, to;           // where it begins and ends, along from the point; may be infinite
    Vec2<Number> first, last;  // its ends, far away if it has none
    Number friction;
    int next;     // the wall that begins where this one ends; -1: none
    bool pierces; // whether its ends draw links back
};

/// Walls as the laws read them, with a grid of squares: those that come into square (column, row) are members[first[i]]
/// … members[first[i + 1] − 1], i = row × columns + column. Squares on the edge go on to infinity.
template <class Number> struct WallsView {
    const Wall<Number> *walls;
    Vec2<Number> low; // corner of the grid
    Number per_square;
    int columns, rows;
    const int *first, *members;
};

/// The whole part of a number that is not negative.
inline int whole(float number) { return static_cast<int>(number); }
inline int whole(double number) { return static_cast<int>(number); }
template <class One> auto whole(One one) -> decltype(static_cast<int>(one.value)) {
    return static_cast<int>(one.value);
}

/// The column or row of squares that holds a place; a number that is not finite is in some of them.
template <class T, class Number> int square_at(T place, Number low, Number per_square, int count) {
    const T squares = (place - T(low)) * T(per_square);
    if (!(T(0) < squares)) return 0;
    return squares < T(count) ? whole(squares) : count - 1;
}

/// Calls visit(number of the wall) for each wall that comes near a box, for some more than once.
template <class T, class Number, class Visit>
void each_wall_near(const WallsView<Number> &walls, Vec2<T> low, Vec2<T> high, const Visit &visit) {
    const int left = square_at(low.x, walls.low.x, walls.per_square, walls.columns),
              right = square_at(high.x, walls.low.x, walls.per_square, walls.columns),
              bottom = square_at(low.y, walls.low.y, walls.per_square, walls.rows),
              top = square_at(high.y, walls.low.y, walls.per_square, walls.rows);
    for (int row = bottom; row <= top; ++row)
        for (int column = left; column <= right; ++column) {
            const int square = row * walls.columns + column;
            for (int i = walls.first[square]; i < walls.first[square + 1]; ++i) visit(walls.members[i]);
        }
}

/// What a node meets on its way in a step: nothing if the time is above 1.
template <class T> struct Meeting {
    T time = 2; // as a share of the way
    GroundPlane<T> plane;
    T friction = 0;
};

/// The place of a node relative to a wall: how far it is from the nearest point, and in which direction.
template <class T> struct Nearness {
    T distance;
    Vec2<T> away, nearest; // nearest: a point of the plane across `away` through the nearest point

    template <class Number> Nearness(const Wall<Number> &wall, Vec2<T> place) {
        using std::abs, std::sqrt;
        const Vec2<T> offset = place - as<T>(wall.point), along = as<T>(wall.along),
                      normal = right_normal(along);
        const T u = dot(offset, along), height = dot(offset, normal);
        const bool before = u < T(wall.from), after = T(wall.to) < u;
        away = height < T(0) ? -normal : normal;
        distance = abs(height), nearest = as<T>(wall.point);
        if (!before && !after) return;
        nearest = as<T>(before ? wall.first : wall.last);
        const Vec2<T> from_end = place - nearest;
        distance = sqrt(squared_length(from_end));
        if (T(0) < distance) away = from_end * (T(1) / distance);
    }
    GroundPlane<T> plane_at(T height) const { return {nearest + away * height, away}; }
};

/// A way into the circle of this radius about a wall's end.
template <class T> Meeting<T> meeting_with_end(Vec2<T> end, Vec2<T> start, Vec2<T> way, T radius, T reach) {
    using std::sqrt;
    const T length = sqrt(squared_length(way));
    if (!(T(0) < length)) return {};
    const Vec2<T> direction = way * (T(1) / length), offset = end - start;
    const T ahead = dot(offset, direction), aside = cross(direction, offset);
    const T squared_chord = radius * radius - aside * aside;
    if (!(T(0) < ahead) || !(T(0) < squared_chord)) return {};
    const T until = ahead - sqrt(squared_chord);
    const Vec2<T> from_end = direction * until - offset;
    const Vec2<T> away = from_end * (T(1) / sqrt(squared_length(from_end)));
    return {until / length, {end + away * reach, away}, T(0)};
}

/// What a node that starts its way here meets of a wall. The wall and all within `reach` of it is closed to the node;
/// reach is the skin, or, where the node is nearer, its distance and a little more, for rounding.
template <class T, class Number>
Meeting<T> meeting_with(const Wall<Number> &wall, Vec2<T> start, Vec2<T> way) {
    using std::min;
    const Nearness<T> near(wall, start);
    const T rounding = rounding_at(start), reach = min(T(8) * rounding, near.distance + rounding),
            closed = reach - T(0.5) * rounding;
    if (near.distance < closed) { // by rounding
        if (!(near.distance + dot(near.away, way) < closed)) return {};
        return {T(0), near.plane_at(reach), T(0)};
    }

    // Of its two sides and two ends the one that the way comes to first.
    const Vec2<T> offset = start - as<T>(wall.point), along = as<T>(wall.along), normal = right_normal(along);
    const T height = dot(offset, normal);
    const bool below = height < T(0);
    const T above = below ? -height : height, approach = below ? dot(way, normal) : -dot(way, normal);
    Meeting<T> first;
    if (!(above < closed) && T(0) < approach) {
        const T time = (above - closed) / approach, u = dot(offset, along) + time * dot(way, along);
        const Vec2<T> away = below ? -normal : normal;
        if (!(u < T(wall.from)) && !(T(wall.to) < u))
            first = {time, {as<T>(wall.point) + away * reach, away}, T(0)};
    }
    for (const Vec2<T> end : {as<T>(wall.first), as<T>(wall.last)}) {
        const Meeting<T> of_end = meeting_with_end(end, start, way, closed, reach);
        if (of_end.time < first.time) first = of_end;
    }
    return first;
}

/// The first that a node meets of all walls.
template <class T, class Number>
Meeting<T> first_met(const WallsView<Number> &walls, Vec2<T> start, Vec2<T> way) {
    using std::max, std::min;
    const T reach = T(16) * rounding_at(start);
    const Vec2<T> end = start + way, low{min(start.x, end.x) - reach, min(start.y, end.y) - reach},
                  high{max(start.x, end.x) + reach, max(start.y, end.y) + reach};
    Meeting<T> first;
    each_wall_near(walls, low, high, [&](int i) {
        Meeting<T> met = meeting_with(walls.walls[i], start, way);
        met.friction = T(walls.walls[i].friction);
        if (met.time < first.time) first = met;
    });
    return first;
}

/// The velocity after contact of a node with whatever walls it meets on its way in a step: with one after another, and
/// 0 if four contacts do not let it go on.
template <class T, class Number>
Vec2<T> contact_with_walls(const WallsView<Number> &walls, Vec2<T> position, Vec2<T> velocity, T time_step) {
    constexpr int most_contacts = 4;
    for (int contacts = 0;; ++contacts) {
        const Meeting<T> met = first_met(walls, position, velocity * time_step);
        if (!(met.time <= T(1))) return velocity;
        if (contacts == most_contacts) return {T(0), T(0)};
        velocity = ground_contact(position, velocity, met.plane, met.friction, time_step);
    }
}

/// Whether a wall and the link from a to b cross.
template <class T> bool crosses(const Wall<T> &wall, Vec2<T> a, Vec2<T> b) {
    const Vec2<T> normal = right_normal(wall.along), link = b - a;
    const bool a_below = dot(a - wall.point, normal) < 0, b_below = dot(b - wall.point, normal) < 0;
    return a_below != b_below && (cross(link, wall.first - a) > 0) != (cross(link, wall.last - a) > 0);
}

/// The forces on both ends of a link.
template <class T> struct LinkForces { Vec2<T> on_a, on_b; };

/// Draws a link of the outline back from the walls that have pierced it: −∇U of U = stiffness/2·d², d the distance
/// between the link and the deepest of the corners that have entered the body through it, 0 without any. The body is
/// on the left of the link from a to b. U is continuous, for a corner is on the link when it enters.
template <class T> LinkForces<T> pull_back(const WallsView<T> &walls, Vec2<T> a, Vec2<T> b, T stiffness) {
    using std::max, std::min;
    Vec2<T> deepest, point;
    T squared_depth = 0, t = 0;
    const auto deepen = [&](Vec2<T> corner) {
        const auto foot = foot_on_segment(corner, a, b);
        const T squared = squared_length(corner - foot.point);
        if (!(squared_depth < squared)) return;
        squared_depth = squared, deepest = corner, point = foot.point, t = foot.t;
    };
    const Vec2<T> low{min(a.x, b.x), min(a.y, b.y)}, high{max(a.x, b.x), max(a.y, b.y)};
    each_wall_near(walls, low, high, [&](int entry) {
        const Wall<T> &wall = walls.walls[entry];
        if (!wall.pierces || !crosses(wall, a, b) || !(cross(b - a, wall.last - a) > 0)) return;
        // From where the line of walls enters the body to where it leaves it.
        deepen(wall.last);
        for (int i = wall.next; i >= 0 && i != entry && !crosses(walls.walls[i], a, b);
             i = walls.walls[i].next)
            deepen(walls.walls[i].last);
    });
    const Vec2<T> force = (deepest - point) * stiffness;
    return {force * (1 - t), force * t};
}

} // namespace planula
