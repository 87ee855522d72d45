// SPDX-License-Identifier: MIT
#include "statement/wrap_runs.h"

#include "base/error.h"
#include "base/text.h"
#include "language/wrap.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <type_traits>

namespace planula {

namespace {

const char *const runs_type = "planula.runs";
const char *const setting_type = "planula.setting";
const char *const run_type = "planula.run";
const char *const champion_type = "planula.champion";
const char *const series_type = "planula.series";

// A value of a run after a number of generations.
struct Field {
    RunField described;
    Maybe (*value)(const RunHistory &history, int generations, std::size_t column);
    std::size_t column;
};

// The number in a column; nothing for a text.
template <class Row> Maybe number_in(const Row &row, std::size_t column) {
    Maybe found;
    std::size_t place = 0;
    each_column(row, [&](std::string_view, const auto &value) {
        using Value = std::remove_cvref_t<decltype(value)>;
        if (place++ != column) return;
        if constexpr (std::is_same_v<Value, Maybe>)
            found = value;
        else if constexpr (std::is_arithmetic_v<Value>)
            found = static_cast<double>(value);
    });
    return found;
}

// All number columns of a table but `generation`.
template <class Row>
void add_columns(std::vector<Field> &fields, Maybe (*value)(const RunHistory &, int, std::size_t)) {
    std::size_t column = 0;
    for (const ColumnRow &described : columns()) {
        if (described.file != Row::file_name) continue;
        const std::size_t place = column++;
        if (described.column == "generation" || described.unit.empty()) continue;
        fields.push_back({{described.column, described.unit, described.meaning}, value, place});
    }
}

void sort_by_name(std::vector<Field> &fields) {
    std::sort(fields.begin(), fields.end(),
              [](const Field &a, const Field &b) { return a.described.name < b.described.name; });
}

#define FACT(name, unit, meaning)                                                                            \
    Field {                                                                                                  \
        {#name, unit, meaning},                                                                              \
            [](const RunHistory &history, int generations, std::size_t) -> Maybe {                           \
                return history.after.at(generations).name;                                                   \
            },                                                                                               \
            0                                                                                                \
    }

const std::vector<Field> &fields_of_run() {
    static const std::vector<Field> by_name = [] {
        std::vector<Field> fields{
            FACT(size_entropy, "nats",
                 "entropy of the cell counts of all individuals so far with fitness above 0, Eq. 8"),
            FACT(with_fitness, "individuals", "those individuals"),
            FACT(valid_share, "1", "share of this generation whose penalty factor is above 0"),
            FACT(fitness_spread, "1",
                 "interquartile range of the fitness of the valid individuals of this generation, over the "
                 "highest; missing if that is 0"),
            FACT(direction_resultant, "1",
                 "mean resultant length of the end directions of the individuals in the sample so far that "
                 "moved; missing if none did"),
            FACT(side_switches, "switches", "how often the best so far changed sides")};
        add_columns<GenerationRow>(
            fields, [](const RunHistory &history, int generations, std::size_t column) {
                return number_in(history.generations[static_cast<std::size_t>(generations) - 1], column);
            });
        sort_by_name(fields);
        return fields;
    }();
    return by_name;
}

#undef FACT

const std::vector<Field> &fields_of_champion() {
    static const std::vector<Field> by_name = [] {
        std::vector<Field> fields;
        add_columns<ChampionRow>(fields, [](const RunHistory &history, int generations, std::size_t column) {
            return number_in(history.after.at(generations).champion, column);
        });
        sort_by_name(fields);
        return fields;
    }();
    return by_name;
}

const Field *find_field(const std::vector<Field> &fields, std::string_view name) {
    for (const Field &field : fields)
        if (field.described.name == name) return &field;
    return nullptr;
}

// What a value in Lua shows. A run of -1 stands for all runs of the setting.
struct View {
    RunsShown *shown;
    std::size_t setting;
    int run;
    const Field *field;

    const SettingRuns &runs() const { return shown->data->settings[setting]; }
};

void push_view(lua_State *L, const char *type, const View &view) {
    *static_cast<View *>(lua_newuserdata(L, sizeof(View))) = view;
    luaL_getmetatable(L, type);
    lua_setmetatable(L, -2);
}

const View &view_at(lua_State *L, const char *type) {
    return *static_cast<const View *>(luaL_checkudata(L, 1, type));
}

void push_maybe(lua_State *L, const Maybe &value) {
    if (value)
        lua_pushnumber(L, *value);
    else
        lua_pushboolean(L, 0);
}

// The key of an index operation: a text, or "" for another value.
std::string_view name_of_key(lua_State *L) { return lua_type(L, 2) == LUA_TSTRING ? lua_tostring(L, 2) : ""; }

// A place in a list of `count` things, from 0; nothing outside.
std::optional<std::size_t> place_of_key(lua_State *L, std::size_t count) {
    const double index = lua_tonumber(L, 2);
    if (!(index >= 1 && index <= static_cast<double>(count)) || index != std::floor(index)) return {};
    return static_cast<std::size_t>(index) - 1;
}

[[noreturn]] void refuse_name(lua_State *L, const std::string &owner,
                              const std::vector<std::string_view> &known) {
    const std::string name = lua_isstring(L, 2) ? lua_tostring(L, 2) : luaL_typename(L, 2);
    throw InputError(owner + " has no '" + name + "'" + suggestion(name, known) +
                     " (allowed: " + list_of(known) + ")");
}

std::vector<std::string_view> names_of(const std::vector<Field> &fields,
                                       std::vector<std::string_view> others = {}) {
    for (const Field &field : fields) others.push_back(field.described.name);
    return others;
}

// ---- runs ----

// Notes that a setting is read.
void ask(const View &view) {
    Asked &asked = *view.shown->asked;
    const SettingRuns &setting = view.runs();
    if (std::count(asked.settings.begin(), asked.settings.end(), &setting) == 0)
        asked.settings.push_back(&setting);
    if (!setting.runs.empty()) return;
    asked.missing = true;
    throw InputError("there are no runs of " + setting.spec->name);
}

// The settings with runs, by their place among all.
std::size_t count_present(const RunData &data) {
    return static_cast<std::size_t>(std::count_if(data.settings.begin(), data.settings.end(),
                                                  [](const SettingRuns &s) { return !s.runs.empty(); }));
}

std::size_t find_present(const RunData &data, std::size_t place) {
    std::size_t setting = 0;
    while (data.settings[setting].runs.empty() || place-- != 0) ++setting;
    return setting;
}

int runs_index(lua_State *L) {
    View view = view_at(L, runs_type);
    const RunData &data = *view.shown->data;
    if (lua_type(L, 2) == LUA_TNUMBER) {
        const auto place = place_of_key(L, count_present(data));
        if (!place) return lua_pushnil(L), 1;
        view.setting = find_present(data, *place);
        ask(view);
        return push_view(L, setting_type, view), 1;
    }
    const std::string_view name = name_of_key(L);
    const auto found = std::find_if(data.settings.begin(), data.settings.end(),
                                    [&](const SettingRuns &setting) { return setting.spec->name == name; });
    if (found == data.settings.end()) {
        std::vector<std::string_view> names;
        for (const SettingRuns &setting : data.settings) names.push_back(setting.spec->name);
        refuse_name(L, "runs", names);
    }
    view.setting = static_cast<std::size_t>(found - data.settings.begin());
    ask(view);
    return push_view(L, setting_type, view), 1;
}

int runs_length(lua_State *L) {
    lua_pushnumber(L, static_cast<double>(count_present(*view_at(L, runs_type).shown->data)));
    return 1;
}

// ---- A setting ----

int setting_index(lua_State *L) {
    View view = view_at(L, setting_type);
    const SettingRuns &setting = view.runs();
    if (lua_type(L, 2) == LUA_TNUMBER) {
        const auto place = place_of_key(L, setting.runs.size());
        if (!place) return lua_pushnil(L), 1;
        view.run = static_cast<int>(*place);
        return push_view(L, run_type, view), 1;
    }
    const std::string_view name = name_of_key(L);
    if (name == "name") return lua_pushstring(L, setting.spec->name.c_str()), 1;
    if (name == "title") return lua_pushstring(L, setting.spec->title.c_str()), 1;
    if (name == "generations") return lua_pushnumber(L, setting.generations), 1;
    if (name == "population") return lua_pushnumber(L, setting.spec->parameters.neat.population), 1;
    if (name == "champion") return push_view(L, champion_type, view), 1;
    view.field = find_field(fields_of_run(), name);
    if (!view.field)
        refuse_name(L, "a setting",
                    names_of(fields_of_run(), {"name", "title", "generations", "population", "champion"}));
    return push_view(L, series_type, view), 1;
}

int setting_length(lua_State *L) {
    lua_pushnumber(L, static_cast<double>(view_at(L, setting_type).runs().runs.size()));
    return 1;
}

// ---- A run ----

void push_endpoints(lua_State *L, const View &view) {
    std::vector<EndpointRow> &rows = view.shown->endpoints;
    rows = view.shown->data->endpoints(view.runs(), static_cast<std::size_t>(view.run));
    lua_createtable(L, static_cast<int>(rows.size()), 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        lua_createtable(L, 0, 3);
        lua_pushnumber(L, rows[i].generation + 1);
        lua_setfield(L, -2, "generation");
        lua_pushnumber(L, rows[i].x);
        lua_setfield(L, -2, "x");
        lua_pushnumber(L, rows[i].y);
        lua_setfield(L, -2, "y");
        lua_rawseti(L, -2, static_cast<int>(i + 1));
    }
}

void push_archive(lua_State *L, const View &view) {
    std::vector<ArchiveEntry> &entries = view.shown->archive;
    entries = view.shown->data->archive(view.runs(), static_cast<std::size_t>(view.run));
    lua_createtable(L, static_cast<int>(entries.size()), 0);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        lua_createtable(L, 0, 3);
        lua_pushnumber(L, entries[i].generation + 1);
        lua_setfield(L, -2, "generation");
        lua_pushnumber(L, entries[i].fitness);
        lua_setfield(L, -2, "fitness");
        lua_createtable(L, static_cast<int>(entries[i].behaviour.size()), 0);
        for (std::size_t j = 0; j < entries[i].behaviour.size(); ++j) {
            lua_pushnumber(L, entries[i].behaviour[j]);
            lua_rawseti(L, -2, static_cast<int>(j + 1));
        }
        lua_setfield(L, -2, "behaviour");
        lua_rawseti(L, -2, static_cast<int>(i + 1));
    }
}

int run_index(lua_State *L) {
    View view = view_at(L, run_type);
    const std::string_view name = name_of_key(L);
    if (name == "seed") {
        const auto run = static_cast<std::size_t>(view.run);
        return lua_pushnumber(L, static_cast<double>(view.runs().runs[run].seed)), 1;
    }
    if (name == "endpoints") return push_endpoints(L, view), 1;
    if (name == "archive") return push_archive(L, view), 1;
    if (name == "champion") return push_view(L, champion_type, view), 1;
    view.field = find_field(fields_of_run(), name);
    if (!view.field)
        refuse_name(L, "a run", names_of(fields_of_run(), {"seed", "endpoints", "archive", "champion"}));
    return push_view(L, series_type, view), 1;
}

int champion_index(lua_State *L) {
    View view = view_at(L, champion_type);
    view.field = find_field(fields_of_champion(), name_of_key(L));
    if (!view.field) refuse_name(L, "champion", names_of(fields_of_champion()));
    return push_view(L, series_type, view), 1;
}

// ---- A value after each number of generations ----

Maybe value_of(const View &view, std::size_t run, int generations) {
    return view.field->value(view.runs().histories[run], generations, view.field->column);
}

// The number of generations that is asked for.
int generations_of_key(lua_State *L, const View &view) {
    const double asked = lua_type(L, 2) == LUA_TNUMBER ? lua_tonumber(L, 2) : 0;
    if (!(asked >= 1) || asked != std::floor(asked) || asked > 1e9)
        throw InputError(std::string(view.field->described.name) +
                         "[g] is the value after g generations: g is a whole number from 1 to " +
                         to_text(view.runs().generations));
    const int generations = static_cast<int>(asked);
    view.shown->asked->generations = std::max(view.shown->asked->generations, generations);
    if (generations <= view.runs().generations) return generations;
    view.shown->asked->missing = true;
    throw InputError("the runs of " + view.runs().spec->name + " have " + to_text(view.runs().generations) +
                     " generations, and " + std::string(view.field->described.name) + "[" +
                     to_text(generations) + "] was asked for");
}

int series_index(lua_State *L) {
    const View view = view_at(L, series_type);
    const int generations = generations_of_key(L, view);
    if (view.run >= 0)
        return push_maybe(L, value_of(view, static_cast<std::size_t>(view.run), generations)), 1;
    const std::size_t count = view.runs().runs.size();
    lua_createtable(L, static_cast<int>(count), 0);
    for (std::size_t run = 0; run < count; ++run) {
        push_maybe(L, value_of(view, run, generations));
        lua_rawseti(L, -2, static_cast<int>(run + 1));
    }
    return 1;
}

int series_length(lua_State *L) {
    lua_pushnumber(L, view_at(L, series_type).runs().generations);
    return 1;
}

int refuse_write(lua_State *L) { return luaL_error(L, "runs are read-only"); }

std::vector<RunField> described(const std::vector<Field> &fields) {
    std::vector<RunField> all;
    for (const Field &field : fields) all.push_back(field.described);
    return all;
}

} // namespace

std::vector<RunField> run_fields() { return described(fields_of_run()); }
std::vector<RunField> champion_fields() { return described(fields_of_champion()); }

void wrap_runs(lua_State *L) {
    struct Type {
        const char *name;
        lua_CFunction index, length;
    };
    const Type types[] = {{runs_type, gate<runs_index>, gate<runs_length>},
                          {setting_type, gate<setting_index>, gate<setting_length>},
                          {run_type, gate<run_index>, nullptr},
                          {champion_type, gate<champion_index>, nullptr},
                          {series_type, gate<series_index>, gate<series_length>}};
    for (const auto &[name, index, length] : types) {
        luaL_newmetatable(L, name);
        lua_pushcfunction(L, index);
        lua_setfield(L, -2, "__index");
        lua_pushcfunction(L, gate<refuse_write>);
        lua_setfield(L, -2, "__newindex");
        lua_pushboolean(L, 0);
        lua_setfield(L, -2, "__metatable");
        if (length) {
            lua_pushcfunction(L, length);
            lua_setfield(L, -2, "__len");
        }
        lua_pop(L, 1);
    }
}

void push_runs(lua_State *L, RunsShown &shown) { push_view(L, runs_type, {&shown, 0, -1, nullptr}); }

bool read_series(lua_State *L, int index, std::vector<double> &numbers) {
    if (lua_type(L, index) != LUA_TUSERDATA || !lua_getmetatable(L, index)) return false;
    luaL_getmetatable(L, series_type);
    const bool is_series = lua_rawequal(L, -1, -2) != 0;
    lua_pop(L, 2);
    if (!is_series) return false;
    const View &view = *static_cast<const View *>(lua_touserdata(L, index));
    if (view.run < 0) return false;
    for (int g = 1; g <= view.runs().generations; ++g)
        numbers.push_back(value_of(view, static_cast<std::size_t>(view.run), g).value_or(std::nan("")));
    return true;
}

} // namespace planula
