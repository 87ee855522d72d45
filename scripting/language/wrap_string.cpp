// SPDX-License-Identifier: MIT
// string: without patterns, which may take any time, and without functions that show addresses or bytecode. LuaJIT
// formats numbers and changes case itself, without locale.
#include "language/wrap.h"

namespace planula {

namespace {

// string.find for plain text only; upvalue: Lua's own.
int find_plain(lua_State *L) {
    std::size_t size = 0, sought = 0;
    luaL_checklstring(L, 1, &size);
    luaL_checklstring(L, 2, &sought);
    host_of(L).spend(L, static_cast<std::int64_t>(size) * static_cast<std::int64_t>(sought + 1));
    lua_settop(L, 3);
    if (lua_isnil(L, 3)) lua_pushinteger(L, 1), lua_replace(L, 3);
    lua_pushboolean(L, 1);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, 4, LUA_MULTRET);
    return lua_gettop(L);
}

// string.rep, which counts as instructions by the length of its result; upvalue: Lua's own.
int repeat(lua_State *L) {
    std::size_t size = 0;
    luaL_checklstring(L, 1, &size);
    const lua_Number length = static_cast<lua_Number>(size) * luaL_checknumber(L, 2);
    const lua_Number most = static_cast<lua_Number>(host_of(L).limits.memory);
    if (length > most) return luaL_error(L, "string.rep: a text of %f bytes is too long", length);
    if (length > 0) host_of(L).spend(L, static_cast<std::int64_t>(length / 16));
    lua_settop(L, 2);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, 2, 1);
    return 1;
}

// string.upper and the like, which count as instructions by the length of the text; upvalue: Lua's own.
int counted(lua_State *L) {
    std::size_t size = 0;
    luaL_checklstring(L, 1, &size);
    host_of(L).spend(L, static_cast<std::int64_t>(size));
    lua_settop(L, 1);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, 1, 1);
    return 1;
}

// Whether one of the items of a pattern is %p, with or without flags, width and precision.
bool shows_address(std::string_view pattern) {
    for (std::size_t i = pattern.find('%'); i != pattern.npos; i = pattern.find('%', i)) {
        const std::size_t kind = pattern.find_first_not_of("-+ #0123456789.", i + 1);
        if (kind == pattern.npos) return false;
        if (pattern[kind] == 'p') return true;
        i = kind == i + 1 ? kind + 1 : kind; // %% is one item
    }
    return false;
}

// string.format of texts and numbers; upvalue: Lua's own.
int format(lua_State *L) {
    std::size_t size = 0;
    const char *pattern = luaL_checklstring(L, 1, &size);
    if (shows_address({pattern, size}))
        return luaL_error(L, "string.format: %%p shows an address, which differs from run to run");
    for (int i = 2; i <= lua_gettop(L); ++i) {
        if (!lua_isstring(L, i) && !lua_isboolean(L, i))
            return luaL_error(L, "string.format takes texts and numbers, got %s", luaL_typename(L, i));
        if (lua_isboolean(L, i)) lua_pushstring(L, lua_toboolean(L, i) ? "true" : "false"), lua_replace(L, i);
    }
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, 1);
    return 1;
}

} // namespace

void wrap_string(lua_State *L) {
    lua_pushcfunction(L, luaopen_string);
    lua_call(L, 0, 0);
    lua_getglobal(L, "string");
    lua_newtable(L);
    for (const char *name : {"byte", "char", "len", "sub"}) {
        lua_getfield(L, -2, name);
        lua_setfield(L, -2, name);
    }
    const luaL_Reg guarded[] = {{"find", gate<find_plain>}, {"format", gate<format>},
                                {"lower", gate<counted>},   {"rep", gate<repeat>},
                                {"reverse", gate<counted>}, {"upper", gate<counted>}};
    for (const auto &[name, function] : guarded) {
        lua_getfield(L, -2, name);
        lua_pushcclosure(L, function, 1);
        lua_setfield(L, -2, name);
    }
    lua_remove(L, -2);

    // ("text"):upper() finds the same functions, and no others.
    lua_pushliteral(L, "");
    lua_getmetatable(L, -1);
    lua_pushvalue(L, -3);
    lua_setfield(L, -2, "__index");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_pop(L, 2);
}

} // namespace planula
