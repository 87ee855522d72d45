// SPDX-License-Identifier: MIT
// life: what judging functions see of a finished life, read-only: the fields of evaluation/life.inl that are not
// hidden, and `displacement`. A point is {x, y}; `path` is a list of points. Any other name is an error with the
// nearest one. So is, for a life that ended with development, a field that is known only after locomotion.
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
