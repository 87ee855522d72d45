// SPDX-License-Identifier: MIT
// table: Lua's own functions, which count as instructions by the length of the table that they walk.
#include "language/wrap.h"

#include <utility>

namespace planula {

namespace {

// Upvalues: Lua's own function, and the instructions that it counts as for each entry.
int counted(lua_State *L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    // Lua's functions would write into the view, past its metatable.
    if (lua_getmetatable(L, 1)) return luaL_error(L, "a read-only table cannot be changed");
    const lua_Integer cost = lua_tointeger(L, lua_upvalueindex(2));
    Host &host = host_of(L);
    host.spend(L, static_cast<std::int64_t>(lua_objlen(L, 1)) * cost);
    host.go_deeper(L); // table.sort compares by a function of the script
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
    --host.depth;
    return lua_gettop(L);
}

} // namespace

void wrap_table(lua_State *L) {
    lua_pushcfunction(L, luaopen_table);
    lua_call(L, 0, 0);
    lua_getglobal(L, "table");
    lua_newtable(L);
    const std::pair<const char *, int> costs[] = {{"concat", 1}, {"insert", 1}, {"remove", 1}, {"sort", 20}};
    for (const auto &[name, cost] : costs) {
        lua_getfield(L, -2, name);
        lua_pushinteger(L, cost);
        lua_pushcclosure(L, gate<counted>, 2);
        lua_setfield(L, -2, name);
    }
    lua_remove(L, -2);
}

} // namespace planula
