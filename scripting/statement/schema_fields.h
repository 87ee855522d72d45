// SPDX-License-Identifier: MIT
// The fields of an environment (decision 0025), from its table. `flow` is {x, y}, each a number, the name of a parameter,
// or a function of the step, which is sampled once, here; then `step` and `period` or `till` say at which steps. `regions`
// is a list of {from, to, bottom, top, drag, flow, buoyancy}.
#pragma once

#include "base/box.h"
#include "language/lua_state.h"
#include "physics/environment.h"
#include "statement/reader.h"

#include <functional>
#include <optional>
#include <string>

namespace planula {

/// Reads a number of an environment, or the name of a parameter that stands for it, and notes which under `name`.
using ReadQuantity = std::function<double(Reader &of, const char *key, const std::string &name, bool needed)>;

/// The number that a function gives at x; nothing, and a report, if it fails or gives none that is finite.
std::optional<double> sample_at(LuaState &lua, int function, double x, const Place &place,
                                Problems &problems);

void read_flow(Reader &environment_table, const ReadQuantity &quantity, LuaState &lua,
               Environment &environment, Problems &problems);

/// What a region does not state is as in the environment, which is read already.
void read_regions(Reader &environment_table, const ReadQuantity &quantity, Environment &environment,
                  Problems &problems);

/// The keys from, to, bottom and top, each of which may be missing.
Box read_box(Reader &reader);

} // namespace planula
