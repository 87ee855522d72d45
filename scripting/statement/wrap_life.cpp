// SPDX-License-Identifier: MIT
#include "statement/wrap_life.h"

#include "base/error.h"
#include "base/text.h"
#include "language/wrap.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

namespace {

const char *const life_type = "planula.life";
const char *const path_type = "planula.path";
const char *const point_type = "planula.point";

void push_point(lua_State *L, Vec2d point) {
    *static_cast<Vec2d *>(lua_newuserdata(L, sizeof(Vec2d))) = point;
    luaL_getmetatable(L, point_type);
    lua_setmetatable(L, -2);
}

struct Field {
    std::string_view name;
    KnownAfter known;
    void (*push)(lua_State *L, const Life &life, int self);
};

void push(lua_State *L, double value, int) { lua_pushnumber(L, value); }
void push(lua_State *L, Outcome value, int) { lua_pushstring(L, name_of(value)); }
void push(lua_State *L, Vec2d value, int) { push_point(L, value); }

// The path shows the same slot as the life itself, so it ends with it.
void push(lua_State *L, const std::vector<Vec2d> &, int self) {
    void *slot = lua_touserdata(L, self);
    *static_cast<LifeSlot **>(lua_newuserdata(L, sizeof(LifeSlot *))) = static_cast<LifeSlot *>(slot);
    luaL_getmetatable(L, path_type);
    lua_setmetatable(L, -2);
    // The path keeps the life's userdata alive.
    lua_createtable(L, 1, 0);
    lua_pushvalue(L, self);
    lua_rawseti(L, -2, 1);
    lua_setfenv(L, -2);
}

// By name: the fields of life.inl that scripts see, and the displacement, which follows from them.
const std::vector<Field> &fields() {
    static const std::vector<Field> by_name = [] {
        std::vector<Field> all{
            {"displacement", KnownAfter::locomotion,
             [](lua_State *L, const Life &life, int self) { push(L, life.displacement(), self); }}};
#define FIELD(type, name, initial, unit, known, meaning)                                                     \
    all.push_back({#name, KnownAfter::known,                                                                 \
                   [](lua_State *L, const Life &life, int self) { push(L, life.name, self); }});
#define HIDDEN_FIELD(...)
#include "evaluation/life.inl"
        std::sort(all.begin(), all.end(), [](const Field &a, const Field &b) { return a.name < b.name; });
        return all;
    }();
    return by_name;
}

std::vector<std::string_view> field_names(bool only_grown) {
    std::vector<std::string_view> names;
    for (const Field &field : fields())
        if (!only_grown || field.known == KnownAfter::growth) names.emplace_back(field.name);
    return names;
}

[[noreturn]] void refuse_field(lua_State *L, const std::string &owner,
                               const std::vector<std::string_view> &known) {
    const std::string name = lua_isstring(L, 2) ? lua_tostring(L, 2) : luaL_typename(L, 2);
    throw InputError(owner + " has no '" + name + "'" + suggestion(name, known) +
                     " (allowed: " + list_of(known) + ")");
}

const Life &life_in(const LifeSlot &slot) {
    if (!slot.life) throw InputError("a life can be read only while it is judged");
    return *slot.life;
}

int life_index(lua_State *L) {
    const auto &slot = *static_cast<LifeSlot *>(luaL_checkudata(L, 1, life_type));
    const Life &life = life_in(slot);
    const std::string_view key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    const auto field =
        std::find_if(fields().begin(), fields().end(), [&](const Field &each) { return key == each.name; });
    if (field == fields().end()) refuse_field(L, "life", field_names(slot.only_grown));
    if (slot.only_grown && field->known == KnownAfter::locomotion)
        throw InputError("life." + std::string(key) +
                         " is known only after a body has moved; a start judges by growth alone (allowed: " +
                         list_of(field_names(true)) + ")");
    return field->push(L, life, 1), 1;
}

int point_index(lua_State *L) {
    const auto &point = *static_cast<Vec2d *>(luaL_checkudata(L, 1, point_type));
    const std::string_view key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    if (key == "x") return lua_pushnumber(L, point.x), 1;
    if (key == "y") return lua_pushnumber(L, point.y), 1;
    refuse_field(L, "a point", {"x", "y"});
}

const Life &life_of_path(lua_State *L) {
    return life_in(**static_cast<LifeSlot **>(luaL_checkudata(L, 1, path_type)));
}

int path_index(lua_State *L) {
    const Life &life = life_of_path(L);
    if (lua_type(L, 2) != LUA_TNUMBER)
        return luaL_error(L, "life.path is a list of points: path[1] … path[#path]");
    const double index = lua_tonumber(L, 2);
    if (!(index >= 1 && index <= static_cast<double>(life.path.size())) || index != std::floor(index))
        return lua_pushnil(L), 1;
    push_point(L, life.path[static_cast<std::size_t>(index) - 1]);
    return 1;
}

int path_length(lua_State *L) {
    lua_pushnumber(L, static_cast<double>(life_of_path(L).path.size()));
    return 1;
}

int refuse_write(lua_State *L) { return luaL_error(L, "a life is read-only"); }

} // namespace

void wrap_life(lua_State *L) {
    const std::pair<const char *, lua_CFunction> types[] = {
        {life_type, gate<life_index>}, {path_type, gate<path_index>}, {point_type, gate<point_index>}};
    for (const auto &[type, index] : types) {
        luaL_newmetatable(L, type);
        lua_pushcfunction(L, index);
        lua_setfield(L, -2, "__index");
        lua_pushcfunction(L, gate<refuse_write>);
        lua_setfield(L, -2, "__newindex");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
        if (type == path_type) {
            lua_pushcfunction(L, gate<path_length>);
            lua_setfield(L, -2, "__len");
        }
        lua_pop(L, 1);
    }
}

LifeSlot &push_life(lua_State *L) {
    auto &slot = *static_cast<LifeSlot *>(lua_newuserdata(L, sizeof(LifeSlot)));
    slot = {nullptr, false};
    luaL_getmetatable(L, life_type);
    lua_setmetatable(L, -2);
    return slot;
}

} // namespace planula
