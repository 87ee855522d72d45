// SPDX-License-Identifier: MIT
// Where errors cross between C++ and Lua. An exception must not pass through a frame of Lua, so every function of C++
// that Lua calls is given to Lua as gate<function>, which turns an exception into a Lua error; no other code of this
// room catches exceptions. In the other direction a script runs in protected mode, and LuaState::take_message() alone
// turns its error into a text, which the caller throws as InputError or counts.
//
// A function behind the gate throws InputError where it can. A Lua error may jump over destructors: no object that owns
// memory may exist while one is raised.
#pragma once

#include <exception>

#include <lua.hpp>

namespace planula {

/// Keeps the message of an exception with the state.
void keep_message(lua_State *L, const char *message) noexcept;
/// Raises the message that was kept, with the position of the caller in front.
int raise_kept_message(lua_State *L);

/// `function` as Lua may call it.
template <lua_CFunction function> int gate(lua_State *L) {
    try {
        return function(L);
    } catch (const std::exception &error) {
        keep_message(L, error.what());
    }
    return raise_kept_message(L); // the exception is gone: a Lua error may jump from here
}

} // namespace planula
