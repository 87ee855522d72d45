// SPDX-License-Identifier: MIT
#include "language/gate.h"

#include "language/lua_state.h"

namespace planula {

void keep_message(lua_State *L, const char *message) noexcept { host_of(L).thrown = message; }

int raise_kept_message(lua_State *L) {
    const std::string &message = host_of(L).thrown;
    luaL_where(L, 1);
    lua_pushlstring(L, message.data(), message.size());
    lua_concat(L, 2);
    return lua_error(L);
}

} // namespace planula
