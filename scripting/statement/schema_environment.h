// SPDX-License-Identifier: MIT
// The environment of a setting, from its table. `ground` is "none", "flat", or a line (statement/schema_line.h); what
// else there is to touch is read by statement/schema_obstacles.h.
#pragma once

#include "language/lua_state.h"
#include "physics/environment.h"
#include "statement/reader.h"

#include <map>
#include <string>

namespace planula {

/// Where a script states a number of an environment itself, "file.lua:12", by the number's name
/// (experiment/world_numbers.h).
using Places = std::map<std::string, std::string, std::less<>>;

struct World {
    Environment environment;
    double actuation_range = 0;
    std::map<std::string, std::string, std::less<>> sources; // Spec::world_sources
    Places places;
};

World read_environment(const Value &table, const Place &place, const Parameters &parameters, LuaState &lua,
                       Problems &problems);

} // namespace planula
