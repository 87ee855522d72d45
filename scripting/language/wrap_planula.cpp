// SPDX-License-Identifier: MIT
// planula: what the prelude (planula.lua) builds on.
#include "language/convert.h"
#include "language/wrap.h"
#include "parameters/parameters.h"

namespace planula {

namespace {

int locate(lua_State *L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_settop(L, 1);
    keep_site(L);
    return 1;
}

} // namespace

void push_value(lua_State *L, const ParameterRow &row, double value) {
    if (!row.is_choice()) return lua_pushnumber(L, value);
    const std::string_view name = row.names[static_cast<std::size_t>(value)];
    lua_pushlstring(L, name.data(), name.size());
}

void wrap_planula(lua_State *L) {
    lua_newtable(L);
    lua_pushcfunction(L, gate<locate>);
    lua_setfield(L, -2, "locate");
    lua_newtable(L);
    for (const ParameterRow &row : parameter_rows()) {
        lua_pushlstring(L, row.name.data(), row.name.size());
        push_value(L, row, row.standard);
        lua_rawset(L, -3);
    }
    freeze(L, "planula.parameters");
    lua_setfield(L, -2, "parameters");
}

} // namespace planula
