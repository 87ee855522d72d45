// SPDX-License-Identifier: MIT
// Points and lines of an environment: a list of points {x, y}, or {height = function(x) … end, from = …, to = …,
// step = …}, which is sampled once, here: at `from`, from + step and so on, never beyond `to`, and at `to`.
#pragma once

#include "base/vec2.h"
#include "language/lua_state.h"
#include "statement/reader.h"

#include <optional>
#include <vector>

namespace planula {

/// {x, y}.
std::optional<Vec2d> read_point(const Value &value);
/// A list of points; reports every entry that is none.
std::vector<Vec2d> read_points(const Value &list, const Place &place, Problems &problems);
/// A list of two points or more, or a height function with these keys.
std::vector<Vec2d> read_line(const Value &table, const Place &place, const Keys &keys, LuaState &lua,
                             Problems &problems);

} // namespace planula
