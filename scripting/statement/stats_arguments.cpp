// SPDX-License-Identifier: MIT
#include "statement/stats_arguments.h"

#include "analysis/chance.h"
#include "base/error.h"
#include "base/text.h"
#include "language/wrap.h"
#include "statement/wrap_runs.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planula {

namespace {

[[noreturn]] void refuse_value(lua_State *L, const std::string &name, std::size_t place, std::size_t count) {
    const std::string which = name + ": value " + to_text(static_cast<std::int64_t>(place)) + " of " +
                              to_text(static_cast<std::int64_t>(count)) + " is ";
    if (lua_isboolean(L, -1) && !lua_toboolean(L, -1))
        throw InputError(which + "missing (false): leave it out with stats.present");
    if (lua_type(L, -1) == LUA_TNUMBER)
        throw InputError(which + (std::isnan(lua_tonumber(L, -1)) ? "nan" : "infinite") +
                         ", and must be finite");
    throw InputError(which + luaL_typename(L, -1) + ", not a number");
}

constexpr double most_resamples = 1e7;

} // namespace

void read_numbers(lua_State *L, int index, const std::string &name, Numbers &numbers) {
    numbers.clear();
    if (read_series(L, index, numbers)) {
        const auto missing =
            std::find_if(numbers.begin(), numbers.end(), [](double x) { return std::isnan(x); });
        if (missing == numbers.end()) return;
        throw InputError(name + " has no value after " + to_text(missing - numbers.begin() + 1) +
                         " generations");
    }
    if (!lua_istable(L, index))
        throw InputError(name + " must be a list of numbers, not " + luaL_typename(L, index));
    const std::size_t count = lua_objlen(L, index);
    for (std::size_t i = 1; i <= count; ++i) {
        lua_rawgeti(L, index, static_cast<int>(i));
        if (lua_type(L, -1) != LUA_TNUMBER) refuse_value(L, name, i, count);
        numbers.push_back(lua_tonumber(L, -1));
        if (!std::isfinite(numbers.back())) refuse_value(L, name, i, count);
        lua_pop(L, 1);
    }
}

void read_samples(lua_State *L, StatsContext &context) {
    read_numbers(L, 1, "a", context.a);
    read_numbers(L, 2, "b", context.b);
}

void read_curves(lua_State *L, int index, const std::string &name, std::vector<Numbers> &curves) {
    curves.clear();
    if (!lua_istable(L, index))
        throw InputError(name + " must be a list of curves, not " + luaL_typename(L, index));
    for (std::size_t i = 1; i <= lua_objlen(L, index); ++i) {
        const std::string which = name + "[" + to_text(static_cast<std::int64_t>(i)) + "]";
        lua_rawgeti(L, index, static_cast<int>(i));
        read_numbers(L, lua_gettop(L), which, curves.emplace_back());
        lua_pop(L, 1);
        check_sample(curves.back());
    }
}

Numbers places_of(std::size_t count) {
    Numbers places;
    for (std::size_t i = 0; i < count; ++i) places.push_back(static_cast<double>(i));
    return places;
}

std::vector<Curve> curves_at(const std::vector<Numbers> &curves, std::span<const double> places) {
    std::vector<Curve> chosen;
    for (const double place : places) chosen.emplace_back(curves[static_cast<std::size_t>(place)]);
    return chosen;
}

int whole(double value, const std::string &name) {
    if (value == std::floor(value) && std::abs(value) <= std::numeric_limits<int>::max())
        return static_cast<int>(value);
    throw InputError(name + " = " + to_text(value) + " must be a whole number");
}

double number_at(lua_State *L, int index, const std::string &name) {
    if (lua_type(L, index) != LUA_TNUMBER)
        throw InputError(name + " must be a number, not " + luaL_typename(L, index));
    return lua_tonumber(L, index);
}

Options::Options(lua_State *L, int index, std::span<const std::string_view> allowed) : L_(L), index_(index) {
    if (lua_isnoneornil(L, index)) return;
    if (!lua_istable(L, index))
        throw InputError(std::string("the options must be a table, not ") + luaL_typename(L, index));
    for (lua_pushnil(L); lua_next(L, index); lua_pop(L, 1)) {
        const std::string_view key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : "";
        if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
            throw InputError("there is no option '" + std::string(key) + "'" + suggestion(key, allowed) +
                             " (allowed: " + list_of(allowed) + ")");
    }
}

// Pushes the field if it is there; it must be of that type.
bool Options::push(const char *name, int type) {
    if (lua_isnoneornil(L_, index_)) return false;
    lua_pushstring(L_, name);
    lua_rawget(L_, index_);
    if (lua_isnil(L_, -1)) return lua_pop(L_, 1), false;
    if (lua_type(L_, -1) == type) return true;
    throw InputError(std::string(name) + " must be a " + lua_typename(L_, type) + ", not " +
                     luaL_typename(L_, -1));
}

double Options::number(const char *name, double absent) {
    if (!push(name, LUA_TNUMBER)) return absent;
    const double value = lua_tonumber(L_, -1);
    return lua_pop(L_, 1), value;
}

bool Options::boolean(const char *name, bool absent) {
    if (!push(name, LUA_TBOOLEAN)) return absent;
    const bool value = lua_toboolean(L_, -1) != 0;
    return lua_pop(L_, 1), value;
}

std::string Options::text(const char *name, const std::string &absent) {
    if (!push(name, LUA_TSTRING)) return absent;
    std::string value = lua_tostring(L_, -1);
    return lua_pop(L_, 1), value;
}

std::size_t Options::choice(const char *name, std::span<const std::string_view> words) {
    const std::string word = text(name, std::string(words.front()));
    const auto found = std::find(words.begin(), words.end(), word);
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    throw InputError(std::string(name) + ": '" + word + "' is not one of " + list_of(words) +
                     suggestion(word, words));
}

int resamples_of(Options &options, const char *name, const StatsContext &context) {
    const double asked = options.number(name, context.analysis->resamples);
    if (!(asked >= 1 && asked <= most_resamples))
        throw InputError(std::string(name) + " = " + to_text(asked) + " must be from 1 to 10000000");
    return std::min(whole(asked, name), context.most_resamples);
}

std::uint64_t seed_of(Options &options, const StatsContext &context) {
    const std::string name = options.text("name", "");
    return bootstrap_seed(name.empty() ? context.stream : context.stream + " " + name);
}

void spend(lua_State *L, double work) {
    host_of(L).spend(L, static_cast<std::int64_t>(std::min(work, 1e15)));
}

int push_result(lua_State *L, const char *what, std::initializer_list<Entry> entries, const char *method) {
    lua_createtable(L, 0, static_cast<int>(entries.size()) + 1);
    for (const Entry &entry : entries) {
        lua_pushnumber(L, entry.value);
        lua_setfield(L, -2, entry.name);
    }
    if (method) {
        lua_pushstring(L, method);
        lua_setfield(L, -2, "method");
    }
    freeze(L, what);
    return 1;
}

int push_list(lua_State *L, const Numbers &numbers) {
    lua_createtable(L, static_cast<int>(numbers.size()), 0);
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        lua_pushnumber(L, numbers[i]);
        lua_rawseti(L, -2, static_cast<int>(i + 1));
    }
    return 1;
}

int push_number(lua_State *L, double value) { return lua_pushnumber(L, value), 1; }

} // namespace planula
