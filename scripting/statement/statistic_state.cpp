// SPDX-License-Identifier: MIT
#include "statement/statistic_state.h"

#include "analysis/example_runs.h"
#include "base/check.h"
#include "base/error.h"
#include "base/text.h"
#include "language/wrap.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace planula {

namespace {

constexpr Limits limits_of(Allowance allowance) {
    if (allowance == Allowance::trial)
        return {.memory = 128u << 20, .allocated = 512u << 20, .instructions = 50'000'000, .seconds = 3};
    return {.memory = 512u << 20,
            .allocated = std::size_t{64} << 30,
            .instructions = 40'000'000'000,
            .seconds = 300};
}

constexpr int trial_resamples = 100;

constexpr std::string_view finding_keys[] = {"verdict", "effect_name", "effect",        "low", "high",
                                             "p",       "method",      "p_equivalence", "note"};

bool is_one_line(std::string_view text) {
    return text.find_first_of(std::string_view("\r\n\0", 3)) == text.npos;
}

bool is_column_name(std::string_view name) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    };
    return !name.empty() && std::all_of(name.begin(), name.end(), allowed);
}

// The text at the top of the stack.
std::string_view text_at_top(lua_State *L) {
    std::size_t size = 0;
    const char *text = lua_tolstring(L, -1, &size);
    return {text, size};
}

} // namespace

// A function of the script: what it is called in messages, and where it stands.
struct StatisticState::Call {
    std::string what; // "the judge of claim 'S1'"
    int function;     // a reference
    std::string place;

    [[noreturn]] void refuse(const std::string &why) const { throw InputError(place + what + " " + why); }
};

namespace {

// "file:line: " of a function that is a reference.
std::string place_of(lua_State *L, int function) {
    lua_Debug stated;
    lua_rawgeti(L, LUA_REGISTRYINDEX, function);
    lua_getinfo(L, ">S", &stated);
    return std::string(stated.short_src) + ":" + to_text(stated.linedefined) + ": ";
}

// The statistics in what a script or a module returned.
const Value &statistics_in(const Value &result, bool in_script) {
    const Value *statistics = in_script ? result.find("statistics") : &result;
    CHECK(statistics);
    return *statistics;
}

int function_in(const Value *owner, const std::string &name) {
    const Value *function = owner ? owner->find(name) : nullptr;
    CHECK(function && function->is(Value::Kind::function), name);
    return function->function;
}

} // namespace

StatisticState::StatisticState(const StatisticSource &source, const Analysis &analysis, Allowance allowance)
    : lua_(source.sources,
           source.module.empty() ? source.sources->script() : source.sources->module(source.module)),
      in_script_(source.module.empty()), allowance_(allowance), context_{.analysis = &analysis} {
    context_.most_resamples =
        allowance == Allowance::trial ? trial_resamples : std::numeric_limits<int>::max();
    if (const auto message = lua_.inspect(gate<prepare>, this, limits_of(allowance)))
        throw InputError(*message);
}

// Makes the two values that are passed to every call.
int StatisticState::prepare(lua_State *L) {
    StatisticState &self = *static_cast<StatisticState *>(lua_touserdata(L, 1));
    wrap_runs(L);
    push_runs(L, self.shown_);
    self.runs_ = luaL_ref(L, LUA_REGISTRYINDEX);
    push_stats(L, self.context_);
    self.stats_ = luaL_ref(L, LUA_REGISTRYINDEX);
    return 0;
}

// Makes the third value of a judge.
int StatisticState::push_claim(lua_State *L) {
    StatisticState &self = *static_cast<StatisticState *>(lua_touserdata(L, 1));
    const Claim &claim = self.case_->claim;
    lua_createtable(L, 0, 5);
    for (const auto &[key, text] :
         {std::pair{"id", &claim.id}, std::pair{"a", &claim.a}, std::pair{"b", &claim.b}}) {
        if (text->empty()) continue;
        lua_pushlstring(L, text->data(), text->size());
        lua_setfield(L, -2, key);
    }
    const int planned = self.case_->data.analysis.design.design.generations;
    lua_pushnumber(L, claim.generation > 0 ? claim.generation : planned);
    lua_setfield(L, -2, "generation");
    lua_pushnumber(L, self.case_->generations);
    lua_setfield(L, -2, "at_generation");
    freeze(L, "claim");
    luaL_unref(L, LUA_REGISTRYINDEX, self.claim_);
    self.claim_ = luaL_ref(L, LUA_REGISTRYINDEX);
    return 0;
}

// Calls the function below its arguments; false if data are missing, else one result is on the stack.
bool StatisticState::call(const Call &call, int arguments) {
    const auto message = lua_.call(arguments, limits_of(allowance_));
    if (!message) return true;
    if (allowance_ == Allowance::reduce && shown_.asked->missing && !exhausted()) return false;
    throw InputError(*message + " (in " + call.what + ")");
}

Finding StatisticState::judge(std::size_t place, const ClaimCase &of, Asked &asked) {
    const Value *claims = statistics_in(lua_.result(), in_script_).find("claims");
    CHECK(claims && place < claims->list.size(), place);
    lua_State *L = lua_.raw();
    const int function = function_in(&claims->list[place], "judge");
    const Call judge{"the judge of claim '" + of.claim.id + "'", function, place_of(L, function)};
    shown_.data = &of.data, shown_.asked = &asked, case_ = &of;
    context_.stream = "claim " + of.claim.id;
    if (const auto message = lua_.inspect(gate<push_claim>, this, limits_of(allowance_)))
        throw InputError(*message);
    lua_rawgeti(L, LUA_REGISTRYINDEX, judge.function);
    lua_rawgeti(L, LUA_REGISTRYINDEX, runs_);
    lua_rawgeti(L, LUA_REGISTRYINDEX, stats_);
    lua_rawgeti(L, LUA_REGISTRYINDEX, claim_);
    return call(judge, 3) ? take_finding(judge) : Finding{};
}

OwnTable StatisticState::make(const std::string &name, const RunData &data, Asked &asked) {
    lua_State *L = lua_.raw();
    const int function = function_in(statistics_in(lua_.result(), in_script_).find("tables"), name);
    const Call make{"the table '" + name + "'", function, place_of(L, function)};
    shown_.data = &data, shown_.asked = &asked;
    context_.stream = "table " + name;
    lua_rawgeti(L, LUA_REGISTRYINDEX, make.function);
    lua_rawgeti(L, LUA_REGISTRYINDEX, runs_);
    lua_rawgeti(L, LUA_REGISTRYINDEX, stats_);
    return call(make, 2) ? take_table(make) : OwnTable{};
}

// ---- What a judge returned ----

namespace {

// Sets a number or a text of a finding from the value at the top of the stack; says what is wrong, or nothing.
std::string set_number(lua_State *L, Maybe &number, bool is_p) {
    if (lua_type(L, -1) != LUA_TNUMBER) return std::string("a number, not ") + luaL_typename(L, -1);
    number = lua_tonumber(L, -1);
    if (!std::isfinite(*number)) return std::isnan(*number) ? "finite, not nan" : "finite, not infinite";
    return is_p && !(*number >= 0 && *number <= 1) ? "from 0 to 1, not " + to_text(*number) : "";
}

std::string set_text(lua_State *L, std::string &text) {
    if (lua_type(L, -1) != LUA_TSTRING) return std::string("a text, not ") + luaL_typename(L, -1);
    text = text_at_top(L);
    return is_one_line(text) ? "" : "one line";
}

std::string set_entry(lua_State *L, std::string_view key, Finding &finding) {
    if (key == "verdict") return set_text(L, finding.verdict);
    if (key == "effect_name") return set_text(L, finding.effect_name);
    if (key == "method") return set_text(L, finding.method);
    if (key == "note") return set_text(L, finding.note);
    if (key == "effect") return set_number(L, finding.effect, false);
    if (key == "low") return set_number(L, finding.low, false);
    if (key == "high") return set_number(L, finding.high, false);
    if (key == "p") return set_number(L, finding.p, true);
    CHECK(key == "p_equivalence", std::string(key));
    return set_number(L, finding.p_equivalence, true);
}

} // namespace

Finding StatisticState::take_finding(const Call &call) {
    lua_State *L = lua_.raw();
    if (!lua_istable(L, -1))
        call.refuse(std::string("returned ") + luaL_typename(L, -1) + ", not a table with a verdict");
    Finding finding;
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
        const std::string key = lua_type(L, -2) == LUA_TSTRING ? lua_tostring(L, -2) : luaL_typename(L, -2);
        if (std::find(std::begin(finding_keys), std::end(finding_keys), key) == std::end(finding_keys))
            call.refuse("returned '" + key + "'" + suggestion(key, finding_keys) +
                        " (allowed: " + list_of(finding_keys) + ")");
        const std::string rule = set_entry(L, key, finding);
        if (!rule.empty()) call.refuse("returned a " + key + " that must be " + rule);
    }
    lua_pop(L, 1);
    if (std::find(verdicts().begin(), verdicts().end(), finding.verdict) == verdicts().end())
        call.refuse("returned the verdict '" + finding.verdict + "', which is not one of " +
                    list_of(verdicts()) + suggestion(finding.verdict, verdicts()));
    return finding;
}

// ---- What a table's function returned ----

namespace {

// The names in the list at the top of the stack; says what is wrong, or nothing.
std::string read_names(lua_State *L, std::vector<std::string> &columns) {
    if (!lua_istable(L, -1))
        return std::string("returned columns that must be a list of names, not ") + luaL_typename(L, -1);
    const int count = static_cast<int>(lua_objlen(L, -1));
    for (int i = 1; i <= count; ++i) {
        lua_rawgeti(L, -1, i);
        if (lua_type(L, -1) == LUA_TSTRING) columns.emplace_back(text_at_top(L));
        lua_pop(L, 1);
        if (static_cast<int>(columns.size()) != i) return "returned columns that must be a list of names";
    }
    return "";
}

// The names in the list `columns` of the table at the top of the stack, if it has one; says what is wrong, or nothing.
std::string read_columns(lua_State *L, std::vector<std::string> &columns) {
    std::string problem;
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING || !problem.empty()) continue;
        const std::string_view key = lua_tostring(L, -2);
        problem = key == "columns" ? read_names(L, columns)
                                   : "returned '" + std::string(key) + "' beside its rows (allowed: columns)";
    }
    return problem;
}
// The names of the row at the top of the stack, in alphabetical order.
std::vector<std::string> names_of_row(lua_State *L) {
    std::vector<std::string> names;
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1))
        if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(lua_tostring(L, -2));
    std::sort(names.begin(), names.end());
    return names;
}

// The value at the top of the stack as a cell; says what is wrong, or nothing.
std::string read_cell(lua_State *L, OwnTable::Cell &cell) {
    if (lua_type(L, -1) == LUA_TNUMBER) {
        cell = lua_tonumber(L, -1);
        const double number = std::get<double>(cell);
        return std::isfinite(number) ? ""
               : std::isnan(number)  ? "must be finite, not nan"
                                     : "must be finite, not infinite";
    }
    if (lua_type(L, -1) != LUA_TSTRING)
        return std::string("must be a number or a text, not ") + luaL_typename(L, -1);
    cell = std::string(text_at_top(L));
    return is_one_line(std::get<std::string>(cell)) ? "" : "must be one line";
}

// The row at the top of the stack; says what is wrong, or nothing.
std::string read_row(lua_State *L, const std::vector<std::string> &columns,
                     std::vector<OwnTable::Cell> &cells) {
    cells.resize(columns.size());
    for (lua_pushnil(L); lua_next(L, -2); lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING) return "a row is {column = value}, and this one has a list";
        const std::string name = lua_tostring(L, -2);
        const auto column = std::find(columns.begin(), columns.end(), name);
        if (column == columns.end())
            return "has '" + name + "', which is not a column" + suggestion(name, columns) +
                   " (columns: " + list_of(columns) + ")";
        const std::string rule = read_cell(L, cells[static_cast<std::size_t>(column - columns.begin())]);
        if (!rule.empty()) return name + " " + rule;
    }
    return "";
}

void check_columns(const std::vector<std::string> &columns, std::string &problem) {
    for (std::size_t i = 0; i < columns.size() && problem.empty(); ++i) {
        if (!is_column_name(columns[i]))
            problem = "has the column '" + columns[i] + "', which must be a name of letters, digits and '_'";
        else if (std::count(columns.begin(), columns.end(), columns[i]) > 1)
            problem = "has the column '" + columns[i] + "' twice";
    }
    if (columns.empty() && problem.empty())
        problem = "has neither rows nor columns; return { columns = { … } } for a table without rows";
}

} // namespace

OwnTable StatisticState::take_table(const Call &call) {
    lua_State *L = lua_.raw();
    if (!lua_istable(L, -1))
        call.refuse(std::string("returned ") + luaL_typename(L, -1) + ", not a list of rows");
    OwnTable table;
    const int rows = static_cast<int>(lua_objlen(L, -1));
    std::string problem = read_columns(L, table.columns);
    const bool stated = !table.columns.empty();
    for (int i = 1; i <= rows && problem.empty(); ++i) {
        const std::string row = "row " + to_text(i) + ": ";
        lua_rawgeti(L, -1, i);
        if (!lua_istable(L, -1)) call.refuse(row + "must be a table, not " + luaL_typename(L, -1));
        if (i == 1 && !stated) table.columns = names_of_row(L);
        if (i == 1) check_columns(table.columns, problem);
        if (problem.empty()) problem = read_row(L, table.columns, table.rows.emplace_back());
        if (!problem.empty()) call.refuse(row + problem);
        lua_pop(L, 1);
    }
    if (rows == 0 && problem.empty()) check_columns(table.columns, problem);
    if (!problem.empty()) call.refuse(problem);
    lua_pop(L, 1);
    return table;
}

// ---- As the core calls them ----

std::function<Finding(const ClaimCase &, Asked &)> judge_of(const StatisticSource &source,
                                                            std::size_t place) {
    return [=](const ClaimCase &of, Asked &asked) {
        return StatisticState(source, of.data.analysis, Allowance::reduce).judge(place, of, asked);
    };
}

std::function<OwnTable(const RunData &, Asked &)> table_of(const StatisticSource &source,
                                                           const std::string &name) {
    return [=](const RunData &data, Asked &asked) {
        return StatisticState(source, data.analysis, Allowance::reduce).make(name, data, asked);
    };
}

void try_out(const StatisticSource &source, const Analysis &analysis, std::span<const Spec> settings,
             Problems &problems) {
    if (analysis.claims.empty() && analysis.tables.empty()) return;
    Analysis trial = analysis;
    trial.interval_runs = 1; // so that intervals are made, too
    const std::vector<SettingRuns> examples = example_runs(settings, trial.design);
    const RunData data = example_data(trial, examples);
    StatisticState state(source, trial, Allowance::trial);
    const auto attempt = [&](const auto &call) {
        Asked asked;
        try {
            if (!state.exhausted()) call(asked);
        } catch (const InputError &error) {
            problems.add(error.what());
        }
    };
    int planned = examples.front().generations;
    for (const SettingRuns &example : examples) planned = std::min(planned, example.generations);
    for (std::size_t i = 0; i < trial.claims.size(); ++i)
        attempt([&](Asked &asked) {
            const int wanted = trial.claims[i].generation;
            state.judge(i, {data, trial.claims[i], wanted > 0 ? std::min(wanted, planned) : planned}, asked);
        });
    for (const TableStatement &table : trial.tables)
        attempt([&](Asked &asked) { state.make(table.name, data, asked); });
}

} // namespace planula
