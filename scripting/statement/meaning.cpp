// SPDX-License-Identifier: MIT
#include "statement/meaning.h"

#include "base/check.h"
#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "language/wrap.h"
#include "parameters/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planula {

namespace {

constexpr int most_values = 200000;
constexpr std::size_t most_text = 64u << 20; // bytes
// More than the script has otherwise, for the list of what its functions reach.
constexpr Limits large_limits{.memory = 128u << 20, .allocated = 1024u << 20};

// Numbers first, ascending; then names by their bytes; then false and true.
struct Key {
    int rank;
    double number;
    std::string_view name;

    bool operator<(const Key &other) const {
        if (rank != other.rank) return rank < other.rank;
        return rank == 1 ? name < other.name : number < other.number;
    }
};

struct Upvalue {
    std::string_view name;
    int place; // of lua_getupvalue()

    bool operator<(const Upvalue &other) const {
        return name != other.name ? name < other.name : place < other.place;
    }
};

// The words of a function and the modules that it requires.
struct Text {
    std::string sha256;
    std::vector<Requirement> requirements;
};

// The walk through all that one function reaches, breadth first. Its members own the memory, as a Lua error may leave
// any of its methods.
class Walk {
  public:
    Walk(const Sources &sources, const Sources &by_line, LuaState &lua, int function)
        : sources_(sources), by_line_(by_line), lua_(lua), function_(function) {}

    FunctionMeaning named(const std::string &name) {
        lua_rawgeti(lua_.raw(), LUA_REGISTRYINDEX, function_);
        const auto origin = origin_of(lua_.raw());
        lua_pop(lua_.raw(), 1);
        const std::string place = place_of(origin);
        shown_.place = place;
        if (origin) shown_.lines = lines_of_function(sources_.all().at(origin->source).tokens, origin->word);
        if (!origin)
            problem_ = "is a function of the library, not of a script";
        else if (const auto message = lua_.inspect(gate<run>, this, large_limits))
            problem_ = "cannot be read: " + *message;
        if (!problem_.empty()) throw InputError(place + ": " + name + " " + problem_);
        return {name, hash_.hex(), place};
    }
    const std::set<std::string_view> &parameters() const { return parameters_; }
    const std::set<std::string_view> &fields() const { return fields_; }
    const FunctionText &text() const { return shown_; }

  private:
    enum Place { objects = 1, library, all_modules, bottom = all_modules }; // on the stack

    static int run(lua_State *L) {
        Walk &self = *static_cast<Walk *>(lua_touserdata(L, 1));
        self.hash_.text("function 1"); // the first way to compute this hash
        lua_settop(L, 0);
        lua_newtable(L); // objects: by number, and the number of each
        lua_getfield(L, LUA_REGISTRYINDEX, library_names);
        luaL_findtable(L, LUA_REGISTRYINDEX, modules, 1);
        lua_rawgeti(L, LUA_REGISTRYINDEX, self.function_);
        self.value(L);
        for (int i = 1; i <= self.count_ && self.problem_.empty(); ++i) {
            lua_rawgeti(L, objects, i);
            if (lua_istable(L, -1))
                self.table(L);
            else
                self.function(L);
            lua_settop(L, bottom);
        }
        return 0;
    }

    // Hashes the value at the top, which it pops: a table or function by its number.
    void value(lua_State *L) {
        const int type = lua_type(L, -1);
        hash_.number(type);
        if (++values_ > most_values) problem_ = "closes over more than 200000 values";
        if (type == LUA_TBOOLEAN)
            hash_.number(lua_toboolean(L, -1));
        else if (type == LUA_TNUMBER)
            number(lua_tonumber(L, -1));
        else if (type == LUA_TSTRING)
            text(name_at(L, -1));
        else if (type == LUA_TTABLE || type == LUA_TFUNCTION)
            object(L);
        else if (type != LUA_TNIL)
            problem_ = std::string("closes over a value of type ") + lua_typename(L, type);
        lua_pop(L, 1);
    }

    // All NaNs have one hash: their bits depend on the processor.
    void number(double value) {
        hash_.number(std::isnan(value) ? std::numeric_limits<double>::quiet_NaN() : value);
    }

    void text(std::string_view value) {
        if ((text_ += value.size()) > most_text)
            problem_ = "closes over more than 64 MB of text";
        else
            hash_.text(value);
        note(value);
        note_field(value);
    }

    // Keeps a word that is the name of a parameter.
    void note(std::string_view word) {
        for (const ParameterRow &row : parameter_rows())
            if (row.name == word) parameters_.insert(row.name);
    }

    // Keeps a word that is the name of something that a life tells.
    void note_field(std::string_view word) {
        for (const LifeField &field : life_fields())
            if (field.name == word) fields_.insert(field.name);
        for (const ObservationRow &row : observation_rows())
            if (row.name == word) fields_.insert(row.name);
    }

    static std::string_view name_at(lua_State *L, int index) {
        std::size_t size = 0;
        const char *name = lua_tolstring(L, index, &size);
        return {name, size};
    }

    void object(lua_State *L) {
        lua_pushvalue(L, -1);
        lua_rawget(L, library);
        if (lua_isstring(L, -1)) {
            hash_.number(0).text(name_at(L, -1));
            const bool reaches_modules = name_at(L, -1) == "require";
            lua_pop(L, 1);
            if (reaches_modules) lua_pushvalue(L, all_modules), value(L);
            return;
        }
        lua_pop(L, 1);
        hash_.number(number_of(L));
    }

    // The number of the object at the top; a new one is kept.
    int number_of(lua_State *L) {
        lua_pushvalue(L, -1);
        lua_rawget(L, objects);
        const int known = static_cast<int>(lua_tointeger(L, -1));
        lua_pop(L, 1);
        if (known > 0) return known;
        lua_pushvalue(L, -1);
        lua_rawseti(L, objects, ++count_);
        lua_pushvalue(L, -1);
        lua_pushinteger(L, count_);
        lua_rawset(L, objects);
        return count_;
    }

    // The entries of the table at the top, by their keys, and its metatable.
    void table(lua_State *L) {
        gather_keys(L);
        std::sort(keys_.begin(), keys_.end());
        // The length of a list with holes does not follow from its entries.
        hash_.number(keys_.size()).number(lua_objlen(L, -1));
        for (const Key &key : keys_) {
            push_key(L, key);
            lua_pushvalue(L, -1);
            value(L);
            lua_rawget(L, -2);
            value(L);
            if (!problem_.empty()) return;
        }
        if (!lua_getmetatable(L, -1)) lua_pushnil(L);
        value(L);
    }

    void gather_keys(lua_State *L) {
        keys_.clear();
        for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
            const int type = lua_type(L, -2);
            if (type == LUA_TNUMBER)
                keys_.push_back({0, lua_tonumber(L, -2), {}});
            else if (type == LUA_TSTRING)
                keys_.push_back({1, 0, name_at(L, -2)});
            else if (type == LUA_TBOOLEAN)
                keys_.push_back({2, static_cast<double>(lua_toboolean(L, -2)), {}});
            else
                problem_ = std::string("closes over a table with a key of type ") + lua_typename(L, type) +
                           ", and such keys have no order";
        }
    }

    static void push_key(lua_State *L, const Key &key) {
        if (key.rank == 0) lua_pushnumber(L, key.number);
        if (key.rank == 1) lua_pushlstring(L, key.name.data(), key.name.size());
        if (key.rank == 2) lua_pushboolean(L, key.number != 0);
    }

    // The words of the function at the top, its upvalues and the modules that it requires.
    void function(lua_State *L) {
        static const Text of_c{"a function of the library", {}}; // an iterator of pairs or ipairs
        const bool is_first = texts_.empty();
        const Text &stated = lua_iscfunction(L, -1) ? of_c : text_of(L);
        hash_.text(stated.sha256);
        upvalues_.clear();
        for (int i = 1; const char *name = lua_getupvalue(L, -1, i); ++i) {
            upvalues_.push_back({name, i});
            lua_pop(L, 1);
        }
        std::sort(upvalues_.begin(), upvalues_.end());
        hash_.number(upvalues_.size());
        for (const Upvalue &upvalue : upvalues_) {
            hash_.text(upvalue.name);
            lua_getupvalue(L, -1, upvalue.place);
            if (is_first)
                shown_.upvalues.emplace_back(
                    upvalue.name, shown_value(L, lua_isfunction(L, -1) ? place_of(origin_of(L)) : ""));
            value(L);
        }
        for (const Requirement &requirement : stated.requirements) required(L, requirement);
    }

    void required(lua_State *L, const Requirement &requirement) {
        lua_pushvalue(L, all_modules);
        if (requirement.module.empty()) return value(L);
        module_ = requirement.module;
        std::replace(module_.begin(), module_.end(), '/', '.');
        hash_.text(module_);
        lua_getfield(L, -1, module_.c_str());
        value(L);
        lua_pop(L, 1);
    }

    // The word `function` that one begins with.
    struct Origin {
        std::size_t source, word; // by number, in their lists
        auto operator<=>(const Origin &) const = default;
    };

    // Of the function at the top; nothing for one of the library.
    std::optional<Origin> origin_of(lua_State *L) const {
        lua_Debug function;
        lua_pushvalue(L, -1);
        lua_getinfo(L, ">S", &function);
        const auto number = parse_int(std::string_view(function.source).substr(1));
        if (!number) return std::nullopt;
        const auto source = static_cast<std::size_t>(*number);
        return Origin{source, function_before(by_line_.all().at(source).tokens, function.linedefined)};
    }

    const Text &text_of(lua_State *L) {
        const auto origin = origin_of(L);
        CHECK(origin);
        const auto [found, is_new] = texts_.try_emplace(*origin);
        Text &text = found->second;
        if (!is_new) return text;
        const std::vector<Token> body =
            body_of_function(sources_.all().at(origin->source).tokens, origin->word);
        Hash words;
        std::string_view before;
        for (const Token &token : body) {
            words.number(static_cast<int>(token.kind)).text(token.word);
            note(token.word);
            if (before == "." || token.kind == Token::Kind::text) note_field(token.word);
            before = token.word;
        }
        text.sha256 = words.hex();
        text.requirements = requirements_of(body);
        return text;
    }

    // "file.lua:12"; of a function of the library where the script states it.
    std::string place_of(const std::optional<Origin> &origin) const {
        const Source &stated = sources_.all().at(origin ? origin->source : 0);
        const int line = origin ? stated.tokens.at(origin->word).line : line_of_return(stated.tokens);
        return stated.name + ":" + to_text(line);
    }

    const Sources &sources_, &by_line_;
    LuaState &lua_;
    const int function_; // a reference of lua_
    Hash hash_;
    int count_ = 0; // of objects
    int values_ = 0;
    std::size_t text_ = 0;
    std::string problem_, module_;
    std::vector<Key> keys_;
    std::vector<Upvalue> upvalues_;
    std::map<Origin, Text> texts_;
    std::set<std::string_view> parameters_, fields_; // whose names were met
    FunctionText shown_;
};

} // namespace

Meanings::Meanings(const Sources &sources)
    : sources_(sources), by_line_(sources.with_functions_on_lines()),
      lua_(by_line_, by_line_->script(), large_limits) {}

// Settings often share their functions.
const Meanings::Known &Meanings::of_function(int function, const std::string &name) {
    lua_rawgeti(lua_.raw(), LUA_REGISTRYINDEX, function);
    const auto [known, is_new] = known_.try_emplace(lua_topointer(lua_.raw(), -1));
    lua_pop(lua_.raw(), 1);
    if (is_new) {
        Walk walk(sources_, *by_line_, lua_, function);
        known->second.meaning = walk.named(name);
        known->second.parameters = walk.parameters();
        known->second.fields = walk.fields();
        known->second.text = walk.text();
    }
    return known->second;
}

void Meanings::visit_functions(std::size_t index, const Visit &visit) {
    const Value *settings = lua_.result().find("settings");
    const Value &setting = settings ? settings->list.at(index) : lua_.result();
    const auto visit_one = [&](const Value *owner, const std::string &key, const std::string &name) {
        const Value *function = owner ? owner->find(key) : nullptr;
        CHECK(function && function->is(Value::Kind::function), name);
        visit(name, of_function(function->function, name));
    };
    for (const char *name : {"fitness", "penalty", "behaviour"}) visit_one(&setting, name, name);
    if (const Value *start = setting.find("start")) visit_one(start, "behaviour", "start.behaviour");
    if (const Value *objectives = setting.find("objectives"))
        for (const Value &objective : objectives->list)
            if (objective.is(Value::Kind::table))
                visit_one(&objective, "value", "objective " + objective.find("name")->text);
}

std::vector<FunctionMeaning> Meanings::of_setting(std::size_t index) {
    std::vector<FunctionMeaning> meanings;
    visit_functions(index, [&](const std::string &name, const Known &function) {
        meanings.push_back(function.meaning);
        meanings.back().name = name;
    });
    return meanings;
}

std::vector<FunctionText> Meanings::texts_of_setting(std::size_t index) {
    std::vector<FunctionText> texts;
    visit_functions(index, [&](const std::string &name, const Known &function) {
        texts.push_back(function.text);
        texts.back().name = name;
    });
    return texts;
}

bool Meanings::mentions(std::size_t index, std::string_view parameter) {
    bool found = false;
    visit_functions(index, [&](const std::string &, const Known &function) {
        found = found || function.parameters.contains(parameter);
    });
    return found;
}

ObservationSet Meanings::observed(std::size_t index) {
    ObservationSet observed;
    visit_functions(index, [&](const std::string &, const Known &function) {
        int number = 0;
        for (const ObservationRow &row : observation_rows()) {
            if (function.fields.contains(row.name)) observed.add(static_cast<Observation>(number));
            ++number;
        }
    });
    return observed;
}

std::string Meanings::reads_without(std::size_t index, std::string_view field, std::string_view parameter) {
    std::string found;
    visit_functions(index, [&](const std::string &name, const Known &function) {
        if (found.empty() && function.fields.contains(field) && !function.parameters.contains(parameter))
            found = function.meaning.place + ": " + name;
    });
    return found;
}

} // namespace planula
