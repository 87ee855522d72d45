// SPDX-License-Identifier: MIT
#include "language/convert.h"

#include "base/error.h"
#include "language/lua_state.h"
#include "language/wrap.h"

#include <algorithm>

namespace planula {

namespace {

constexpr int deepest = 16;         // tables in tables
constexpr int most_values = 200000; // in all

const char *const sites = "sites";

class Converter {
  public:
    Converter(lua_State *L, const std::string &script) : L_(L), script_(script) {}

    // Converts the value at the top, which stays there.
    Value value(int depth) {
        if (depth > deepest) fail("tables are nested more than 16 deep, or contain themselves");
        if (++values_ > most_values) fail("the result has more than 200000 values");
        Value result;
        switch (lua_type(L_, -1)) {
        case LUA_TBOOLEAN:
            result.kind = Value::Kind::boolean;
            result.boolean = lua_toboolean(L_, -1) != 0;
            break;
        case LUA_TNUMBER:
            result.kind = Value::Kind::number;
            result.number = unsigned_zero(lua_tonumber(L_, -1));
            break;
        case LUA_TSTRING: {
            std::size_t size = 0;
            const char *text = lua_tolstring(L_, -1, &size);
            result.kind = Value::Kind::text;
            result.text.assign(text, size);
            break;
        }
        case LUA_TFUNCTION:
            result.kind = Value::Kind::function;
            lua_pushvalue(L_, -1);
            result.function = luaL_ref(L_, LUA_REGISTRYINDEX);
            break;
        case LUA_TTABLE:
            table(result, depth);
            break;
        default:
            fail(std::string("a value of type ") + luaL_typename(L_, -1) + " cannot be part of a result");
        }
        return result;
    }

  private:
    [[noreturn]] void fail(const std::string &why) { throw InputError(script_ + ": " + why); }

    void table(Value &result, int depth) {
        result.kind = Value::Kind::table;
        result.site = site();
        luaL_checkstack(L_, 4, "result");
        std::vector<std::pair<double, Value>> list;
        for (lua_pushnil(L_); lua_next(L_, -2); lua_pop(L_, 1)) {
            if (lua_type(L_, -2) == LUA_TNUMBER) {
                const double index = lua_tonumber(L_, -2);
                list.emplace_back(index, value(depth + 1));
            } else if (lua_type(L_, -2) == LUA_TSTRING) {
                std::size_t size = 0;
                const char *text = lua_tolstring(L_, -2, &size);
                result.fields.push_back({std::string(text, size), value(depth + 1)});
            } else {
                fail(std::string("a key of type ") + luaL_typename(L_, -2) + " cannot be part of a result");
            }
        }
        // Lua walks a table in no particular order: sort.
        std::sort(result.fields.begin(), result.fields.end(),
                  [](const auto &a, const auto &b) { return a.name < b.name; });
        std::sort(list.begin(), list.end(), [](const auto &a, const auto &b) { return a.first < b.first; });
        for (std::size_t i = 0; i < list.size(); ++i) {
            if (list[i].first != static_cast<double>(i + 1))
                fail("a list must have the indices 1 to n, without a gap");
            result.list.push_back(std::move(list[i].second));
        }
    }

    Site site() {
        Site found;
        lua_getfield(L_, LUA_REGISTRYINDEX, sites);
        if (lua_istable(L_, -1)) {
            lua_pushvalue(L_, -2);
            lua_rawget(L_, -2);
            if (lua_istable(L_, -1)) {
                lua_rawgeti(L_, -1, 1);
                lua_rawgeti(L_, -2, 2);
                found = {lua_tostring(L_, -2), static_cast<int>(lua_tointeger(L_, -1))};
                lua_pop(L_, 2);
            }
            lua_pop(L_, 1);
        }
        lua_pop(L_, 1);
        return found;
    }

    lua_State *L_;
    const std::string &script_;
    int values_ = 0;
};

} // namespace

const char *name_of(Value::Kind kind) {
    constexpr const char *names[] = {"nothing", "true or false", "a number",
                                     "a text",  "a function",    "a table"};
    return names[static_cast<int>(kind)];
}

Value convert(lua_State *L, const std::string &script) {
    if (!lua_istable(L, -1))
        throw InputError(script +
                         ": the script must return planula.experiment {…} or paper.experiment {…}, not " +
                         luaL_typename(L, -1));
    Value result = Converter(L, script).value(0);
    lua_pop(L, 1);
    return result;
}

void keep_site(lua_State *L) {
    // The keys are weak: the site of a table is removed with the table.
    lua_getfield(L, LUA_REGISTRYINDEX, sites);
    if (!lua_istable(L, -1)) {
        lua_pop(L, 1);
        lua_newtable(L);
        lua_createtable(L, 0, 1);
        lua_pushliteral(L, "k");
        lua_setfield(L, -2, "__mode");
        lua_setmetatable(L, -2);
        lua_pushvalue(L, -1);
        lua_setfield(L, LUA_REGISTRYINDEX, sites);
    }

    // Only a table that the main source itself made has a line there; one that a module made has that of the statement
    // it belongs to.
    const Source &main = *host_of(L).main;
    lua_Debug frame{};
    bool found = false;
    for (int level = 1; !found && lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        found = frame.currentline > 0 && frame.source != std::string_view("@planula.lua");
    }
    if (found && frame.source + 1 == std::string_view(main.name)) {
        lua_pushvalue(L, -2);
        lua_createtable(L, 2, 0);
        lua_pushstring(L, frame.source + 1);
        lua_rawseti(L, -2, 1);
        lua_pushinteger(L, frame.currentline);
        lua_rawseti(L, -2, 2);
        lua_rawset(L, -3);
    }
    lua_pop(L, 1);
}

} // namespace planula
