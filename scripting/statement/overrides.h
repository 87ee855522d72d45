// SPDX-License-Identifier: MIT
// Parameters set from outside the script, on the command line, and whether that changes anything: a setting may state
// the number itself, or have no part that reads the parameter.
#pragma once

#include "parameters/parameters.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planula {

struct Experiment;

/// By name, in order; later ones win.
using Overrides = std::vector<std::pair<std::string, double>>;

/// Why setting this parameter changes nothing, if it changes nothing in any setting: a line for each reason, with the
/// settings, and where a script states the number itself its line and what to write there. "" if some setting may read
/// the parameter.
std::string why_without_effect(const Experiment &experiment, std::string_view parameter);

/// Why one setting's lives and search do not read the parameter, as the end of a sentence that begins with the setting;
/// "" if they may. Its functions may read it all the same.
std::string why_unread_by(const Experiment &experiment, std::size_t setting, const ParameterRow &row);

} // namespace planula
