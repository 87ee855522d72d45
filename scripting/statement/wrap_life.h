// SPDX-License-Identifier: MIT
// life: what judging functions see of a finished life, read-only: the fields of evaluation/life.inl that are not
// hidden, `displacement`, and the observations (evaluation/observations.inl) that the life was asked for. A point is
// {x, y}; `path` is a list of points, `signals` a list of lists. Any other name is an error with the nearest one. So is
// an observation that was not asked for, and, for a life that ended with development, what is known only after
// locomotion.
#pragma once

#include "evaluation/life.h"

#include <lua.hpp>

namespace planula {

/// The life that Lua's `life` shows at the moment; null outside a judgement.
struct LifeSlot {
    const Life *life;
    bool only_grown; // it ended with development
};

/// Registers the type of `life` in a state.
void wrap_life(lua_State *L);

/// Pushes a `life` that shows nothing yet; its slot exists as long as the value does. May raise.
LifeSlot &push_life(lua_State *L);

} // namespace planula
