// SPDX-License-Identifier: MIT
// Which parameters decide what a run does in a generation, and which only say how much is done or how results are
// read: two runs that differ in the latter alone are the same run. The judge is shown the former only.
// A setting need not read all of the former: a search without species reads no age of species.
#pragma once

#include "experiment/spec.h"
#include "parameters/parameters.h"

#include <string>
#include <string_view>

namespace planula {

/// False for the number of seeds and of generations, and for what statistics alone read.
bool decides_lives(const ParameterRow &row);

/// Why the judge is not shown a parameter, as the end of a sentence; "" for one that it is shown, or for a name
/// that no parameter has.
std::string why_not_shown(std::string_view name);

/// Why no command reads a parameter in this setting, as the end of a sentence that begins with the setting; "" if one
/// may read it. The setting's judging functions may read it all the same.
std::string why_unread(const ParameterRow &row, const Spec &spec);

/// Whether the setting's search reads the behaviour of individuals.
bool reads_behaviour(const Spec &spec);

} // namespace planula
