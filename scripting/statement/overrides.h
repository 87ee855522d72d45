// SPDX-License-Identifier: MIT
// Parameters set from outside the script, on the command line, and whether that changes anything: a setting may state
// the number itself, or have no part that reads the parameter.
#pragma once

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

} // namespace planula
