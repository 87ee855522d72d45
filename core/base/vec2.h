// SPDX-License-Identifier: MIT
// A point or vector of the plane. Lengths are in cell diameters. Every operation is a fixed sequence of IEEE additions
// and multiplications, so that a quarter turn of all arguments turns the result to the bit.
#pragma once

#include "base/portable.h"

#include <cmath>

namespace planula {

/// A choice between numbers; base/lanes.h has the same for numbers side by side.
PORTABLE inline float select(bool choice, float yes, float no) { return choice ? yes : no; }
PORTABLE inline double select(bool choice, double yes, double no) { return choice ? yes : no; }

template <class T> struct Vec2 {
    T x = 0, y = 0;

    PORTABLE friend Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    PORTABLE friend Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    PORTABLE friend Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
    PORTABLE friend Vec2 operator*(Vec2 a, T s) { return {a.x * s, a.y * s}; }
    PORTABLE friend Vec2 operator*(T s, Vec2 a) { return {a.x * s, a.y * s}; }
    PORTABLE friend Vec2 operator/(Vec2 a, T s) { return {a.x / s, a.y / s}; }
    friend bool operator==(Vec2 a, Vec2 b) = default;
    PORTABLE Vec2 &operator+=(Vec2 b) { return *this = *this + b; }
    PORTABLE Vec2 &operator-=(Vec2 b) { return *this = *this - b; }
};

using Vec2d = Vec2<double>;
using Vec2f = Vec2<float>;

template <class T> PORTABLE T dot(Vec2<T> a, Vec2<T> b) { return a.x * b.x + a.y * b.y; }
template <class T> PORTABLE T cross(Vec2<T> a, Vec2<T> b) { return a.x * b.y - a.y * b.x; }
template <class T> PORTABLE T squared_length(Vec2<T> a) { return dot(a, a); }
template <class T> PORTABLE T length(Vec2<T> a) { return std::sqrt(dot(a, a)); }
/// The vector turned a quarter turn clockwise: the right-hand normal of a direction.
template <class T> PORTABLE Vec2<T> right_normal(Vec2<T> a) { return {a.y, -a.x}; }
/// Both components by one choice, of a number or lane by lane.
template <class Choice, class T> PORTABLE Vec2<T> select(Choice choice, Vec2<T> yes, Vec2<T> no) {
    return {select(choice, yes.x, no.x), select(choice, yes.y, no.y)};
}
template <class T> bool is_finite(Vec2<T> a) { return std::isfinite(a.x) && std::isfinite(a.y); }

} // namespace planula
