// SPDX-License-Identifier: MIT
// The functions that scripts see, one file per table, and the few tools that these files share. Each passes through
// gate<…> (language/gate.h).
#pragma once

#include "base/text.h"
#include "language/gate.h"
#include "language/lua_state.h"
#include "parameters/parameters.h"

#include <string>
#include <vector>

namespace planula {

/// Each leaves one table of functions on the stack.
void wrap_base(lua_State *L);
void wrap_math(lua_State *L);
void wrap_string(lua_State *L);
void wrap_table(lua_State *L);
void wrap_planula(lua_State *L);

/// A number without the sign of a zero: whether -0 arises depends on the processor (decision 0028).
constexpr double unsigned_zero(double x) { return x + 0.0; }

/// Throws InputError if one of the arguments `first` … `last` of the function `name` is a number that is no index or
/// count on every processor: NaN, or beyond ±2^31.
void check_counts(lua_State *L, const char *name, int first, int last);

/// The reason why a read-only table does not have a name, for the message; "" for none.
using WhyAbsent = std::string (*)(std::string_view name);

/// Replaces the table on the stack by a read-only view of it: a write, or the reading of a name that it does
/// not have, is an error that calls it `name`.
void freeze(lua_State *L, const char *name, WhyAbsent why = nullptr);

/// Loads the modules that functions require by name; none can be loaded after that. Raises an error if one fails.
void load_inner_modules(lua_State *L);

/// Pushes a parameter's value: a number, or the name of a choice.
void push_value(lua_State *L, const ParameterRow &row, double value);

/// Keeps in the registry, as the table `library_names`, the name that scripts use for each function and table of the
/// library: library_names[value] = "math.sqrt".
void name_library(lua_State *L);
inline const char *const library_names = "library names";
/// The modules of the state by name, a table of the registry.
inline const char *const modules = "modules";

/// Compiles a source with the sandbox's globals; leaves the function, or raises.
void load_source(lua_State *L, std::string_view text, const std::string &name);

} // namespace planula
