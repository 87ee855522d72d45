// SPDX-License-Identifier: MIT
// From a table inside Lua to a Value outside.
#pragma once

#include "language/value.h"

#include <string>

#include <lua.hpp>

namespace planula {

/// Pops the value on the stack, which `script` ("file.lua:12") returned, and converts it. Throws InputError if it is
/// not a table, or a table in it is nested too deeply, too large, or has keys that are neither names nor 1 … n.
Value convert(lua_State *L, const std::string &script);

/// Keeps in the state which line of the main source is making the table on the stack, if one is (planula.locate). A
/// tail call (return paper.design {…}) leaves no line: such a table has that of the script's return.
void keep_site(lua_State *L);

} // namespace planula
