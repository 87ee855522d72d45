// SPDX-License-Identifier: MIT
// table: Lua's own functions, which count as instructions by the length of the table that they walk.
#include "base/error.h"
#include "language/wrap.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

namespace planula {

namespace {

// What one comparison of table.sort may cost beyond that of two numbers: Lua compares long texts byte by byte.
std::int64_t longest_text(lua_State *L) {
    std::size_t longest = 0;
    const int size = static_cast<int>(lua_objlen(L, 1));
    for (int i = 1; i <= size; ++i) {
        lua_rawgeti(L, 1, i);
        if (lua_type(L, -1) == LUA_TSTRING) longest = std::max(longest, lua_objlen(L, -1));
        lua_pop(L, 1);
    }
    return static_cast<std::int64_t>(longest);
}

// Refuses a place outside the list, to which Lua would count entry by entry.
void check_place(lua_State *L, const std::string &name, int size) {
    const double place = lua_tonumber(L, 2);
    const bool is_last_of_none = place == size; // table.remove(list, #list) of an empty list
    if (!lua_isnumber(L, 2) || is_last_of_none || (place >= 1 && place <= size + 1)) return;
    throw InputError(name + ": the list has no place " + to_text(place) + " (1 … " + to_text(size + 1) + ")");
}

// Upvalues: Lua's own function, the instructions that it counts as for each entry, its name.
int counted(lua_State *L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    // Lua's functions would write into the view, past its metatable.
    if (lua_getmetatable(L, 1)) return luaL_error(L, "a read-only table cannot be changed");
    const std::string_view name = lua_tostring(L, lua_upvalueindex(3));
    const int size = static_cast<int>(lua_objlen(L, 1));
    std::int64_t cost = lua_tointeger(L, lua_upvalueindex(2));
    if (name == "table.sort") cost += cost * longest_text(L) / 16;
    if (name == "table.insert" && lua_gettop(L) > 2) check_place(L, "table.insert", size);
    if (name == "table.remove" && lua_gettop(L) > 1) check_place(L, "table.remove", size);
    if (name == "table.concat") check_counts(L, "table.concat", 3, 4);
    Host &host = host_of(L);
    host.spend(L, size * cost);
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
        lua_pushfstring(L, "table.%s", name);
        lua_pushcclosure(L, gate<counted>, 3);
        lua_setfield(L, -2, name);
    }
    lua_remove(L, -2);
}

} // namespace planula
