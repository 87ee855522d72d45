// SPDX-License-Identifier: MIT
// runs: what a statistic sees of the runs, read-only (decision 0023).
//
//   runs.ns, runs["osc-aq-ns"]   the runs of a setting; an error if it has none
//   #runs, runs[i]               the settings that have runs, in the order of the experiment
//   setting.name, .title, .generations, .population, #setting, setting[i]
//                                its runs by ascending seed, and the number of generations that all of them have
//   run.seed, run.endpoints, run.archive
//   run.best_fitness[g]          a value after g generations, 1 … generations; false where the run has no such value
//   setting.best_fitness[g]      the same for all runs, a list in the order of the runs
//   run.champion.elongation[g]   a value of the best individual of the run up to then; of a setting, a list
//
// The values are the columns of generations.csv and champions.csv, and those of a run as a whole up to a generation, such
// as size_entropy. Any other name is an error with the nearest one. Reading what is not there, a setting without runs or
// a generation after the last, is an error too, and noted in Asked.
#pragma once

#include "analysis/statistic.h"

#include <span>
#include <string_view>
#include <vector>

#include <lua.hpp>

namespace planula {

/// What Lua's `runs` shows at the moment.
struct RunsShown {
    const RunData *data = nullptr;
    Asked *asked = nullptr;
    // What was read from the files of a run, while it is copied into Lua.
    std::vector<EndpointRow> endpoints{};
    std::vector<ArchiveEntry> archive{};
};

/// A name that scripts may read, described.
struct RunField {
    std::string_view name, unit, meaning;
};
/// Of a run or a setting, after a number of generations.
std::vector<RunField> run_fields();
/// Of `champion`.
std::vector<RunField> champion_fields();

/// Registers the types of `runs` in a state.
void wrap_runs(lua_State *L);

/// Pushes `runs`, which shows what `shown` holds; that must outlive the state. May raise.
void push_runs(lua_State *L, RunsShown &shown);

/// Whether the value is run.best_fitness, say: a series of one run. Then appends its numbers, of all generations.
bool read_series(lua_State *L, int index, std::vector<double> &numbers);

} // namespace planula
