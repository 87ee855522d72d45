// SPDX-License-Identifier: MIT
// What there is to touch beside the ground (decision 0024):
// - obstacles: a list of polygons, each a list of points {x, y} or {points = …, friction = …}
// - ceiling: a line, as a ground (statement/schema_line.h)
// - friction_patches: a list of {from = …, to = …, friction = …}
// - object: {at = {x, y}, shape = a list of points relative to `at`, or radius = …}
#pragma once

#include "language/lua_state.h"
#include "physics/environment.h"
#include "statement/reader.h"

namespace planula {

/// Reads these keys of an environment's table.
void read_obstacles(Reader &reader, const Parameters &parameters, LuaState &lua, Environment &environment,
                    Problems &problems);

} // namespace planula
