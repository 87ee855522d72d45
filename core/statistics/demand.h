// SPDX-License-Identifier: MIT
// What this room demands of its arguments: they come from scripts and data files, so that a broken rule is the user's
// error.
#pragma once

#include "base/error.h"
#include "base/text.h"

#include <string>

namespace planula {

/// Throws InputError "<rule>, not <value>" unless the rule holds.
inline void demand(bool holds, const char *rule, double value) {
    if (!holds) throw InputError(std::string(rule) + ", not " + to_text(value));
}

} // namespace planula
