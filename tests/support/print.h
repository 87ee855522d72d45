// SPDX-License-Identifier: MIT
// How Boost.Test prints planula's own types in a failure.
#pragma once

#include "base/vec2.h"
#include "body/outcome.h"

#include <ostream>

namespace planula {

inline std::ostream &operator<<(std::ostream &out, Outcome outcome) { return out << name_of(outcome); }
template <class T> std::ostream &operator<<(std::ostream &out, Vec2<T> v) {
    return out << '(' << v.x << ", " << v.y << ')';
}

} // namespace planula
