// SPDX-License-Identifier: MIT
// The functions by which an experiment judges its claims and makes tables of its own (decision 0023), in Lua:
//
//   judge(runs, stats, claim)   of a claim; returns {verdict, effect_name, effect, low, high, p, method, p_equivalence,
//                               note}, of which only the verdict is needed
//   tables.name(runs, stats)    returns a list of rows, {column = number or text}, and optionally `columns`, the names
//                               of the columns in their order; without them the columns are those of the first row, in
//                               alphabetical order
//
// runs: statement/wrap_runs.h. stats: statement/wrap_stats.h. claim: {id, a, b, generation, at_generation}, where
// at_generation is `generation`, or as many as the runs of a and b have.
//
// Functions must not keep anything from one call to the next: each call of reduce() has a Lua state of its own.
#pragma once

#include "analysis/statistic.h"
#include "language/lua_state.h"
#include "language/sources.h"
#include "statement/problems.h"
#include "statement/wrap_runs.h"
#include "statement/wrap_stats.h"

#include <cstddef>
#include <memory>
#include <string>

namespace planula {

/// Where an experiment states its statistics: in a module, or, if that is empty, in the script itself.
struct StatisticSource {
    std::shared_ptr<Sources> sources;
    std::string module;
};

/// What a call of a statistic may use.
enum class Allowance {
    reduce, // as much as bootstraps of many runs take
    trial   // little, with few resamples, when a script is checked
};

class StatisticState {
  public:
    /// The analysis must outlive the state. Throws what LuaState throws.
    StatisticState(const StatisticSource &source, const Analysis &analysis, Allowance allowance);

    /// Judges the claim of that place in the list. Throws InputError with the place in the script if its function raises
    /// an error or returns something else; if data are missing (Asked), a reduce gets an empty finding instead.
    Finding judge(std::size_t place, const ClaimCase &of, Asked &asked);
    /// Makes the table of that name, with the same errors.
    OwnTable make(const std::string &name, const RunData &data, Asked &asked);

    /// Whether the last call exceeded a limit.
    bool exhausted() const { return lua_.exhausted() != Exhausted::no; }

  private:
    struct Call;
    static int prepare(lua_State *L);
    static int push_claim(lua_State *L);
    bool call(const Call &call, int arguments);
    Finding take_finding(const Call &call);
    OwnTable take_table(const Call &call);

    LuaState lua_;
    bool in_script_;
    Allowance allowance_;
    RunsShown shown_;
    StatsContext context_;
    const ClaimCase *case_ = nullptr;              // while it is judged
    int runs_ = 0, stats_ = 0, claim_ = LUA_NOREF; // references of lua_
};

/// The function of a claim, and of a table, as the core calls them: each call has a state of its own.
std::function<Finding(const ClaimCase &, Asked &)> judge_of(const StatisticSource &source, std::size_t place);
std::function<OwnTable(const RunData &, Asked &)> table_of(const StatisticSource &source,
                                                           const std::string &name);

/// Calls every function with runs that are made up (analysis/example_runs.h), and reports what they throw.
void try_out(const StatisticSource &source, const Analysis &analysis, std::span<const Spec> settings,
             Problems &problems);

} // namespace planula
