// SPDX-License-Identifier: MIT
#include "language/captures.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "language/wrap.h"

#include <bit>
#include <string>

namespace planula {

namespace {

// A hash of the value at the top, which it pops. No other value can have the same address: the list keeps all values
// alive that had one at first.
std::uint64_t take(lua_State *L) {
    const int type = lua_type(L, -1);
    std::uint64_t bits = 0;
    if (type == LUA_TBOOLEAN)
        bits = static_cast<std::uint64_t>(lua_toboolean(L, -1));
    else if (type == LUA_TNUMBER)
        bits = std::bit_cast<std::uint64_t>(lua_tonumber(L, -1));
    else if (type == LUA_TSTRING)
        bits = reinterpret_cast<std::uintptr_t>(lua_tostring(L, -1)); // texts are interned
    else
        bits = reinterpret_cast<std::uintptr_t>(lua_topointer(L, -1));
    lua_pop(L, 1);
    return mix(bits + mix(static_cast<std::uint64_t>(type)));
}

// Of the entries of the table at the top, in any order, and its length, which does not follow from the entries if it
// has holes.
std::uint64_t digest_of_table(lua_State *L) {
    std::uint64_t sum = mix(lua_objlen(L, -1));
    for (lua_pushnil(L); lua_next(L, -2);) {
        const std::uint64_t value = take(L);
        lua_pushvalue(L, -1);
        sum += mix(take(L) ^ mix(value));
    }
    return sum;
}

std::uint64_t digest_of_function(lua_State *L) {
    std::uint64_t sum = 0;
    for (int i = 1; lua_getupvalue(L, -1, i); ++i) sum = mix(sum + take(L));
    return sum;
}

std::uint64_t digest(lua_State *L) { return lua_istable(L, -1) ? digest_of_table(L) : digest_of_function(L); }

} // namespace

Captures::Captures(LuaState &lua, std::span<const int> functions) : lua_(lua), functions_(functions) {
    if (const auto message = lua_.inspect(gate<list>, this, Limits{.memory = 128u << 20}))
        throw InputError(lua_.main().name + ":" + to_text(line_of_return(lua_.main().tokens)) + ": " +
                         *message);
}

std::optional<std::size_t> Captures::changed() {
    lua_State *L = lua_.raw();
    std::optional<std::size_t> root;
    lua_rawgeti(L, LUA_REGISTRYINDEX, list_);
    for (std::size_t i = 0; i < objects_.size() && !root; ++i) {
        lua_rawgeti(L, -1, static_cast<int>(i + 1));
        if (digest(L) != objects_[i].digest) root = objects_[i].root;
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return root;
}

int Captures::list(lua_State *L) {
    Captures &self = *static_cast<Captures *>(lua_touserdata(L, 1));
    lua_settop(L, 0);
    lua_newtable(L);
    lua_getfield(L, LUA_REGISTRYINDEX, library_names);
    for (std::size_t root = 0; root < self.functions_.size(); ++root) {
        lua_rawgeti(L, LUA_REGISTRYINDEX, self.functions_[root]);
        self.add(L, root);
    }
    if (self.lua_.requires_in_functions()) {
        luaL_findtable(L, LUA_REGISTRYINDEX, modules, 1);
        self.add(L, self.functions_.size());
    }
    for (std::size_t i = 0; i < self.objects_.size(); ++i) {
        lua_rawgeti(L, 1, static_cast<int>(i + 1));
        self.list_parts(L, self.objects_[i].root);
        self.objects_[i].digest = digest(L);
        lua_pop(L, 1);
    }
    lua_settop(L, 1);
    self.list_ = luaL_ref(L, LUA_REGISTRYINDEX);
    return 0;
}

// Adds what the table or function at the top holds.
void Captures::list_parts(lua_State *L, std::size_t root) {
    if (lua_isfunction(L, -1)) {
        for (int i = 1; lua_getupvalue(L, -1, i); ++i) add(L, root);
        return;
    }
    if (lua_getmetatable(L, -1)) add(L, root);
    for (lua_pushnil(L); lua_next(L, -2);) {
        add(L, root);
        lua_pushvalue(L, -1);
        add(L, root);
    }
}

// Keeps the value at the top, which it pops, if it has an address; tables and functions of scripts get a number.
void Captures::add(lua_State *L, std::size_t root) {
    ++values_;
    const int type = lua_type(L, -1);
    if (type == LUA_TNIL || type == LUA_TBOOLEAN || type == LUA_TNUMBER) return lua_pop(L, 1);
    for (const int known_in : {1, 2}) {
        lua_pushvalue(L, -1);
        lua_rawget(L, known_in);
        const bool known = !lua_isnil(L, -1);
        lua_pop(L, 1);
        if (known) return lua_pop(L, 1);
    }
    if (type == LUA_TTABLE || type == LUA_TFUNCTION) {
        objects_.push_back({root, 0});
        lua_pushvalue(L, -1);
        lua_rawseti(L, 1, static_cast<int>(objects_.size()));
    }
    lua_pushboolean(L, 1);
    lua_rawset(L, 1);
}

} // namespace planula
