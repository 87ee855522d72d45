// SPDX-License-Identifier: MIT
#include "statement/wrap_life.h"

#include "base/error.h"
#include "base/text.h"
#include "language/wrap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

namespace {

const char *const life_type = "planula.life";
const char *const list_type = "planula.list";
const char *const point_type = "planula.point";

void push_point(lua_State *L, Vec2d point) {
    *static_cast<Vec2d *>(lua_newuserdata(L, sizeof(Vec2d))) = point;
    luaL_getmetatable(L, point_type);
    lua_setmetatable(L, -2);
}

// Finds a list in a life.
using ListIn = const void *(*)(const Life &life);

// A list of a life: of points, of numbers, of lists of numbers, or one of the latter. It shows the same slot as the
// life itself, so it ends with it.
struct List {
    enum Kind { points, numbers, rows, row };
    LifeSlot *slot;
    ListIn in;
    const char *name;
    Kind kind;
    std::size_t row_index;
};

void push_list(lua_State *L, int self, const List &list) {
    *static_cast<List *>(lua_newuserdata(L, sizeof(List))) = list;
    luaL_getmetatable(L, list_type);
    lua_setmetatable(L, -2);
    // The list keeps the life's userdata alive.
    lua_createtable(L, 1, 0);
    lua_pushvalue(L, self);
    lua_rawseti(L, -2, 1);
    lua_setfenv(L, -2);
}

constexpr List::Kind kind_of(const std::vector<Vec2d> &) { return List::points; }
constexpr List::Kind kind_of(const std::vector<double> &) { return List::numbers; }
constexpr List::Kind kind_of(const Samples &) { return List::rows; }

struct Field {
    std::string_view name;
    KnownAfter known;
    std::optional<Observation> observation;
    void (*push)(lua_State *L, const Life &life, int self);
};

void push(lua_State *L, double value, int, const char *, ListIn) { lua_pushnumber(L, value); }
void push(lua_State *L, Outcome value, int, const char *, ListIn) { lua_pushstring(L, name_of(value)); }
void push(lua_State *L, Vec2d value, int, const char *, ListIn) { push_point(L, value); }
template <class T>
void push(lua_State *L, const std::vector<T> &value, int self, const char *name, ListIn in) {
    push_list(L, self, {static_cast<LifeSlot *>(lua_touserdata(L, self)), in, name, kind_of(value), 0});
}

// By name: the fields of life.inl that scripts see, the displacement, which follows from them, and the observations.
const std::vector<Field> &fields() {
    static const std::vector<Field> by_name = [] {
        std::vector<Field> all{
            {"displacement", KnownAfter::locomotion, std::nullopt,
             [](lua_State *L, const Life &life, int) { lua_pushnumber(L, life.displacement()); }}};
#define PUSH(member, name)                                                                                   \
    [](lua_State *L, const Life &life, int self) {                                                           \
        push(L, life.member, self, #name, [](const Life &of) -> const void * { return &of.member; });        \
    }
#define FIELD(type, name, initial, unit, known, meaning)                                                     \
    all.push_back({#name, KnownAfter::known, std::nullopt, PUSH(name, name)});
#define HIDDEN_FIELD(...)
#include "evaluation/life.inl"
#define OBSERVATION(type, name, initial, unit, known, exists, meaning)                                       \
    all.push_back({#name, KnownAfter::known, Observation::name, PUSH(observations.name, name)});
#include "evaluation/observations.inl"
#undef PUSH
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

// An observation that this life was not asked for.
[[noreturn]] void refuse_observation(Observation one) {
    const ObservationRow &row = observation_rows()[static_cast<std::size_t>(one)];
    const std::string name = "life." + std::string(row.name);
    throw InputError(name +
                     (row.exists.holds ? " exists only " + std::string(row.exists.where) + ", and" : "") +
                     " is computed only for functions that name it: write " + name +
                     " where it is read, not a name that is computed");
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
    if (field->observation && !life.observations.known.has(*field->observation))
        refuse_observation(*field->observation);
    return field->push(L, life, 1), 1;
}

int point_index(lua_State *L) {
    const auto &point = *static_cast<Vec2d *>(luaL_checkudata(L, 1, point_type));
    const std::string_view key = lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : "";
    if (key == "x") return lua_pushnumber(L, point.x), 1;
    if (key == "y") return lua_pushnumber(L, point.y), 1;
    refuse_field(L, "a point", {"x", "y"});
}

const List &list_at_1(lua_State *L) { return *static_cast<List *>(luaL_checkudata(L, 1, list_type)); }

template <class T> const std::vector<T> &values_of(const List &list) {
    return *static_cast<const std::vector<T> *>(list.in(life_in(*list.slot)));
}

std::size_t size_of(const List &list) {
    if (list.kind == List::points) return values_of<Vec2d>(list).size();
    if (list.kind == List::numbers) return values_of<double>(list).size();
    const Samples &rows = values_of<std::vector<double>>(list);
    return list.kind == List::rows ? rows.size() : rows.at(list.row_index).size();
}

int list_index(lua_State *L) {
    const List &list = list_at_1(L);
    const double size = static_cast<double>(size_of(list));
    if (lua_type(L, 2) != LUA_TNUMBER)
        return luaL_error(L, "life.%s is a list%s: %s[1] … %s[#%s]", list.name,
                          list.kind == List::points ? " of points" : "", list.name, list.name, list.name);
    const double number = lua_tonumber(L, 2);
    if (!(number >= 1 && number <= size) || number != std::floor(number)) return lua_pushnil(L), 1;
    const std::size_t index = static_cast<std::size_t>(number) - 1;
    if (list.kind == List::points) push_point(L, values_of<Vec2d>(list)[index]);
    if (list.kind == List::numbers) lua_pushnumber(L, values_of<double>(list)[index]);
    if (list.kind == List::row)
        lua_pushnumber(L, values_of<std::vector<double>>(list)[list.row_index][index]);
    if (list.kind == List::rows) push_list(L, 1, {list.slot, list.in, list.name, List::row, index});
    return 1;
}

int list_length(lua_State *L) {
    lua_pushnumber(L, static_cast<double>(size_of(list_at_1(L))));
    return 1;
}

int refuse_write(lua_State *L) { return luaL_error(L, "a life is read-only"); }

} // namespace

void wrap_life(lua_State *L) {
    const std::pair<const char *, lua_CFunction> types[] = {
        {life_type, gate<life_index>}, {list_type, gate<list_index>}, {point_type, gate<point_index>}};
    for (const auto &[type, index] : types) {
        luaL_newmetatable(L, type);
        lua_pushcfunction(L, index);
        lua_setfield(L, -2, "__index");
        lua_pushcfunction(L, gate<refuse_write>);
        lua_setfield(L, -2, "__newindex");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
        if (type == list_type) {
            lua_pushcfunction(L, gate<list_length>);
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
