// SPDX-License-Identifier: MIT
// What a script states and nothing reads: found in its text and tables, without a simulation.
#pragma once

#include "statement/findings.h"
#include "statement/schema.h"

namespace planula {

/// Reports values of parameters that no setting reads which has them, parameters beside `settings` that every
/// setting overrides, a number of seeds that is not that of the first setting, a behaviour of its own in a setting
/// whose search reads none, and local names of the script that are used nowhere. `paper` has the paper's functions.
void find_unread(const Experiment &experiment, const Experiment &paper, Findings &findings);

} // namespace planula
