// SPDX-License-Identifier: MIT
// string: without patterns, which may take any time, and without functions that show addresses or bytecode. LuaJIT
// formats numbers and changes case itself, without locale.
#include "base/error.h"
#include "language/wrap.h"

#include <string>
#include <string_view>

namespace planula {

namespace {

// string.find for plain text only; upvalue: Lua's own.
int find_plain(lua_State *L) {
    std::size_t size = 0, sought = 0;
    luaL_checklstring(L, 1, &size);
    luaL_checklstring(L, 2, &sought);
    host_of(L).spend(L, static_cast<std::int64_t>(size) * static_cast<std::int64_t>(sought + 1));
    lua_settop(L, 3);
    check_counts(L, "string.find", 3, 3);
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
    luaL_checknumber(L, 2);
    check_counts(L, "string.rep", 2, 2);
    const lua_Number length = static_cast<lua_Number>(size) * lua_tonumber(L, 2);
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

// string.byte, string.char and string.sub, whose numbers are counts; upvalues: Lua's own, the name.
int with_counts(lua_State *L) {
    const std::string_view name = lua_tostring(L, lua_upvalueindex(2));
    check_counts(L, name.data(), name == "string.char" ? 1 : 2, lua_gettop(L));
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
    return lua_gettop(L);
}

// Checks one argument of string.format, for an item of that kind: what it would show must be the same on every
// processor. It is replaced by a text or a number that shows so.
void check_shown(lua_State *L, char kind, int index) {
    if (kind == 'p') throw InputError("string.format: %p shows an address, which differs from run to run");
    if (lua_isboolean(L, index))
        lua_pushstring(L, lua_toboolean(L, index) ? "true" : "false"), lua_replace(L, index);
    if (!lua_isstring(L, index))
        throw InputError(std::string("string.format takes texts and numbers, got ") +
                         luaL_typename(L, index));
    const bool as_text = kind == 's' || kind == 'q' || !lua_isnumber(L, index);
    if (as_text && lua_type(L, index) == LUA_TSTRING) return;
    const double number = unsigned_zero(lua_tonumber(L, index));
    const double most = kind == 'c' ? 2147483648.0 : 9223372036854775808.0; // 2^31, 2^63
    const bool is_whole = std::string_view("cdiouxX").find(kind) != std::string_view::npos;
    if (is_whole && !(number > -most && number < most))
        throw InputError("string.format: %" + std::string(1, kind) + " cannot show " + to_text(number));
    lua_pushnumber(L, number);
    lua_replace(L, index);
}

// string.format of texts and numbers; upvalue: Lua's own.
int format(lua_State *L) {
    std::size_t size = 0;
    const char *text = luaL_checklstring(L, 1, &size);
    const std::string_view pattern(text, size);
    int index = 1;
    for (std::size_t i = pattern.find('%'); i != pattern.npos; i = pattern.find('%', i + 1)) {
        i = pattern.find_first_not_of("-+ #0123456789.", i + 1);
        if (i == pattern.npos) break;
        if (pattern[i] != '%' && ++index <= lua_gettop(L)) check_shown(L, pattern[i], index);
        if (pattern[i] == 'p') check_shown(L, 'p', 1);
    }
    host_of(L).spend(L, static_cast<std::int64_t>(size / 16));
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
    for (const char *name : {"byte", "char", "sub"}) {
        lua_getfield(L, -2, name);
        lua_pushfstring(L, "string.%s", name);
        lua_pushcclosure(L, gate<with_counts>, 2);
        lua_setfield(L, -2, name);
    }
    lua_getfield(L, -2, "len");
    lua_setfield(L, -2, "len");
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
