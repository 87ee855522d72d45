// SPDX-License-Identifier: MIT
// Where errors cross between C++ and Lua. An exception must not pass through a frame of Lua, so every function of C++
// that Lua calls is handed to it as gate<function>, which turns an exception into a Lua error; no other code of this room
// catches one. In the other direction LuaState::take_message() is the only way: what the script does runs in protected
// mode, and its error becomes a message, which the caller throws as InputError or counts.
//
// A function behind the gate throws InputError rather than to raise a Lua error, which may jump over destructors: no object
// that owns memory lives while one is raised.
#pragma once

#include <exception>

#include <lua.hpp>

namespace planula {

/// Keeps the message of an exception in the state's books.
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
