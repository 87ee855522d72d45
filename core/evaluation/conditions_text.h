// SPDX-License-Identifier: MIT
// Conditions as lines of text (base/named_lines.h), for programs that have no Lua: what an experiment states as a
// function is there as what the core made of it, the points of a ground or the samples of a current. Of conditions with
// equal texts every genome has equal lives. What decides no life is left out: what is observed, and the parameters of
// evolution and statistics.
#pragma once

#include "evaluation/conditions.h"

#include <string>
#include <string_view>

namespace planula {

std::string write_conditions(const Conditions &conditions);

/// The same conditions to the bit, with standard values of what is left out. Throws InputError with the line and the
/// rule, also for a parameter outside of its range; and what check_consistency(), check_environment() and
/// check_course() throw.
Conditions read_conditions(std::string_view text);

} // namespace planula
