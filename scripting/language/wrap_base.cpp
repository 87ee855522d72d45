// SPDX-License-Identifier: MIT
// The globals: the functions of Lua's base library that read no address, no file, and no order that changes from
// process to process.
#include "base/error.h"
#include "language/wrap.h"

#include <algorithm>
#include <utility>

namespace planula {

namespace {

const char *const being_loaded = "being loaded";

struct Key {
    bool is_name;
    double number;
    std::string_view name;
    int place; // in the list of keys

    // Numbers first, ascending; then names by their bytes. Keys differ, so the order is total.
    bool operator<(const Key &other) const {
        if (is_name != other.is_name) return other.is_name;
        return is_name ? name < other.name : number < other.number;
    }
};

// Writes the keys of list `keys` (a stack index), sorted, into the list on top.
void sort_keys(lua_State *L, int keys, int count) {
    std::vector<Key> order;
    for (int i = 1; i <= count; ++i) {
        lua_rawgeti(L, keys, i);
        std::size_t size = 0;
        const bool is_name = lua_type(L, -1) == LUA_TSTRING;
        const char *text = is_name ? lua_tolstring(L, -1, &size) : nullptr;
        order.push_back({is_name, is_name ? 0 : lua_tonumber(L, -1), {text, size}, i});
        lua_pop(L, 1);
    }
    std::sort(order.begin(), order.end());
    for (int i = 1; i <= count; ++i) {
        lua_rawgeti(L, keys, order[static_cast<std::size_t>(i - 1)].place);
        lua_rawseti(L, -2, i);
    }
}

// Upvalues: the table, its sorted keys, how many were returned.
int next_pair(lua_State *L) {
    const lua_Integer place = lua_tointeger(L, lua_upvalueindex(3)) + 1;
    lua_pushinteger(L, place);
    lua_replace(L, lua_upvalueindex(3));
    lua_rawgeti(L, lua_upvalueindex(2), static_cast<int>(place));
    if (lua_isnil(L, -1)) return 1;
    lua_pushvalue(L, -1);
    lua_rawget(L, lua_upvalueindex(1));
    return 2;
}

int sorted_pairs(lua_State *L) {
    luaL_checktype(L, 1, LUA_TTABLE);
    lua_settop(L, 1);
    // Of a read-only view, the table behind it.
    if (luaL_getmetafield(L, 1, "__index")) lua_replace(L, 1);

    int count = 0;
    for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1)) {
        const int type = lua_type(L, -2);
        if (type != LUA_TNUMBER && type != LUA_TSTRING)
            return luaL_error(L, "pairs: keys of type %s have no order; use numbers and texts",
                              lua_typename(L, type));
        ++count;
    }
    host_of(L).spend(L, 20L * count);

    // Both lists get their full size here: what follows takes no memory from Lua, so it cannot raise.
    lua_createtable(L, count, 0);
    lua_createtable(L, count, 0);
    int place = 0;
    for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1)) {
        lua_pushvalue(L, -2);
        lua_rawseti(L, 2, ++place);
    }
    sort_keys(L, 2, count);
    lua_pushvalue(L, 1);
    lua_insert(L, 3);
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, gate<next_pair>, 3);
    return 1;
}

int next_index(lua_State *L) {
    const int index = static_cast<int>(luaL_checkinteger(L, 2)) + 1;
    lua_pushinteger(L, index);
    lua_pushinteger(L, index);
    lua_gettable(L, 1);
    return lua_isnil(L, -1) ? 1 : 2;
}

int each_index(lua_State *L) {
    if (!lua_istable(L, 1)) luaL_checktype(L, 1, LUA_TUSERDATA);
    lua_pushcfunction(L, gate<next_index>);
    lua_pushvalue(L, 1);
    lua_pushinteger(L, 0);
    return 3;
}

// select and unpack, whose arguments from the first that is upvalue 2 on are counts; upvalues: Lua's own function, that
// number, the name.
int with_counts(lua_State *L) {
    const int first = static_cast<int>(lua_tointeger(L, lua_upvalueindex(2)));
    check_counts(L, lua_tostring(L, lua_upvalueindex(3)), first, first == 1 ? 1 : 3);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, lua_gettop(L) - 1, LUA_MULTRET);
    return lua_gettop(L);
}

// Tables and functions are named by their type: an address differs from process to process.
int text_of(lua_State *L) {
    luaL_checkany(L, 1);
    switch (lua_type(L, 1)) {
    case LUA_TNUMBER:
        lua_pushnumber(L, unsigned_zero(lua_tonumber(L, 1)));
        lua_tostring(L, -1);
        break;
    case LUA_TSTRING:
        lua_settop(L, 1);
        break;
    case LUA_TBOOLEAN:
        lua_pushstring(L, lua_toboolean(L, 1) ? "true" : "false");
        break;
    default:
        lua_pushstring(L, luaL_typename(L, 1));
    }
    return 1;
}

// Removes from the message at the top what depends on the folder of the script and on the machine: the names and lines
// in front, and the folders that `require` lists after its first line.
void strip_places(lua_State *L) {
    if (lua_type(L, -1) != LUA_TSTRING) return;
    std::size_t size = 0;
    const char *text = lua_tolstring(L, -1, &size);
    std::string_view said(text, size);
    while (const std::size_t length = host_of(L).place_in(said)) said.remove_prefix(length);
    if (said.starts_with("no module '")) said = said.substr(0, said.find(';'));
    lua_pushlstring(L, said.data(), said.size());
    lua_replace(L, -2);
}

// pcall that passes an exceeded limit to its caller, and returns a message without its place: no result may depend on a
// line or the name of a file.
int guarded_pcall(lua_State *L) {
    luaL_checkany(L, 1);
    Host &host = host_of(L);
    const int depth = host.depth;
    host.go_deeper(L);
    const int status = lua_pcall(L, lua_gettop(L) - 1, LUA_MULTRET, 0);
    host.depth = depth;
    if (host.exhausted != Exhausted::no) return luaL_error(L, "the script exceeds its limits");
    if (status != 0) strip_places(L);
    lua_pushboolean(L, status == 0);
    lua_insert(L, 1);
    return lua_gettop(L);
}

int require(lua_State *L) {
    std::size_t size = 0;
    const char *name = luaL_checklstring(L, 1, &size);
    const Source *source = &host_of(L).sources->module({name, size});

    // Each module runs once; one that requires itself would never end.
    luaL_findtable(L, LUA_REGISTRYINDEX, modules, 1);
    lua_getfield(L, -1, source->module.c_str());
    if (lua_type(L, -1) == LUA_TSTRING) return luaL_error(L, "module '%s' requires itself", name);
    if (!lua_isnil(L, -1)) return 1;
    lua_pop(L, 1);
    if (host_of(L).closed)
        return luaL_error(L, "module '%s' is not loaded; write outside all functions: require '%s'", name,
                          name);
    host_of(L).loaded.push_back(source);
    lua_pushstring(L, being_loaded);
    lua_setfield(L, -2, source->module.c_str());
    load_source(L, source->text, source->name);
    lua_call(L, 0, 1);
    if (!lua_istable(L, -1)) return luaL_error(L, "module '%s' must return a table", name);
    lua_pushvalue(L, -1);
    lua_setfield(L, -3, source->module.c_str());
    return 1;
}

const char *message_of(lua_State *L, int error) {
    const char *said = lua_tostring(L, error);
    return said ? said : "an error that is not a text";
}

// Names the functions of the read-only view at the top, and the tables of the globals, in the table below it.
void name_entries(lua_State *L, const char *owner) {
    const int names = lua_gettop(L) - 1;
    luaL_getmetafield(L, -1, "__index");
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
        const bool is_part = lua_istable(L, -1) && *owner == '\0';
        if (!lua_isfunction(L, -1) && !is_part) continue;
        lua_pushvalue(L, -1);
        lua_pushfstring(L, "%s%s", owner, lua_tostring(L, -3));
        lua_rawset(L, names);
        if (!is_part) continue;
        lua_pushvalue(L, names);
        lua_pushvalue(L, -2);
        lua_pushfstring(L, "%s.", lua_tostring(L, -4));
        lua_insert(L, -3);
        name_entries(L, lua_tostring(L, -3));
        lua_pop(L, 3);
    }
    lua_pop(L, 1);
}

// Upvalue: what the frozen table is called.
int refuse_write(lua_State *L) {
    const char *name = lua_tostring(L, lua_upvalueindex(1));
    if (lua_type(L, 2) != LUA_TSTRING) return luaL_error(L, "%s cannot be changed", name);
    if (std::string_view(name) == "a global")
        return luaL_error(L, "'%s' is not local; write: local %s = …", lua_tostring(L, 2),
                          lua_tostring(L, 2));
    return luaL_error(L, "%s.%s cannot be changed", name, lua_tostring(L, 2));
}

// Upvalues: what the frozen table is called, and a WhyAbsent or nil; the argument is the table behind the view.
int refuse_read(lua_State *L) {
    const std::string_view name = lua_tostring(L, lua_upvalueindex(1));
    const auto why = reinterpret_cast<WhyAbsent>(lua_touserdata(L, lua_upvalueindex(2)));
    std::vector<std::string> known;
    for (lua_pushnil(L); lua_next(L, 1); lua_pop(L, 1))
        if (lua_type(L, -2) == LUA_TSTRING) known.emplace_back(lua_tostring(L, -2));
    std::sort(known.begin(), known.end());
    const std::string key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : luaL_typename(L, 2);
    const std::string what =
        name == "a global" ? "nothing is called '" + key + "'" : std::string(name) + " has no '" + key + "'";
    const std::string reason = why ? why(key) : "";
    throw InputError(what + (reason.empty() ? suggestion(key, known) : ": " + reason));
}

} // namespace

void check_counts(lua_State *L, const char *name, int first, int last) {
    constexpr double most = 2147483647;
    for (int i = first; i <= last && i <= lua_gettop(L); ++i) {
        const double count = lua_tonumber(L, i);
        if (!lua_isnumber(L, i) || (count >= -most && count <= most)) continue;
        throw InputError(std::string(name) + ": argument " + to_text(i) + " is " + to_text(count) +
                         ", not a number of -2147483647 … 2147483647");
    }
}

void freeze(lua_State *L, const char *name, WhyAbsent why) {
    // A name that the table does not have is an error.
    lua_createtable(L, 0, 1);
    lua_pushstring(L, name);
    if (why)
        lua_pushlightuserdata(L, reinterpret_cast<void *>(why));
    else
        lua_pushnil(L);
    lua_pushcclosure(L, gate<refuse_read>, 2);
    lua_setfield(L, -2, "__index");
    lua_setmetatable(L, -2);

    lua_newtable(L);
    lua_createtable(L, 0, 3);
    lua_pushvalue(L, -3);
    lua_setfield(L, -2, "__index");
    lua_pushstring(L, name);
    lua_pushcclosure(L, gate<refuse_write>, 1);
    lua_setfield(L, -2, "__newindex");
    lua_pushboolean(L, 0);
    lua_setfield(L, -2, "__metatable");
    lua_setmetatable(L, -2);
    lua_remove(L, -2);
}

void load_inner_modules(lua_State *L) {
    Host &host = host_of(L);
    // A module that is loaded here may have functions that require others.
    for (std::size_t i = 0; i < host.loaded.size(); ++i) {
        const Source &source = *host.loaded[i];
        for (const Requirement &inner : source.requirements) {
            if (!inner.in_function || inner.module.empty()) continue;
            lua_pushcfunction(L, gate<require>);
            lua_pushstring(L, inner.module.c_str());
            if (lua_pcall(L, 1, 1, 0) != 0)
                luaL_error(L, "%s:%d: %s", source.name.c_str(), inner.line, message_of(L, -1));
            lua_pop(L, 1);
        }
    }
    host.closed = true;
}

void name_library(lua_State *L) {
    lua_newtable(L);
    lua_getfield(L, LUA_REGISTRYINDEX, "globals");
    name_entries(L, "");
    lua_pop(L, 1);
    lua_setfield(L, LUA_REGISTRYINDEX, library_names);
}

void load_source(lua_State *L, std::string_view text, const std::string &name) {
    lua_pushfstring(L, "@%s", name.c_str());
    if (luaL_loadbufferx(L, text.data(), text.size(), lua_tostring(L, -1), "t") != 0) lua_error(L);
    lua_remove(L, -2);
    lua_getfield(L, LUA_REGISTRYINDEX, "globals");
    lua_setfenv(L, -2);
}

void wrap_base(lua_State *L) {
    // Lua's own base functions go where scripts do not reach them; the harmless ones are copied.
    lua_pushcfunction(L, luaopen_base);
    lua_call(L, 0, 0);
    lua_newtable(L);
    for (const char *name : {"assert", "error", "tonumber", "type"}) {
        lua_getglobal(L, name);
        lua_setfield(L, -2, name);
    }
    for (const auto &[name, first] : {std::pair{"select", 1}, std::pair{"unpack", 2}}) {
        lua_getglobal(L, name);
        lua_pushinteger(L, first);
        lua_pushstring(L, name);
        lua_pushcclosure(L, gate<with_counts>, 3);
        lua_setfield(L, -2, name);
    }
    const luaL_Reg own[] = {{"ipairs", gate<each_index>},   {"pairs", gate<sorted_pairs>},
                            {"pcall", gate<guarded_pcall>}, {"require", gate<require>},
                            {"tostring", gate<text_of>},    {nullptr, nullptr}};
    luaL_register(L, nullptr, own);
}

} // namespace planula
