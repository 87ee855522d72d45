// SPDX-License-Identifier: MIT
// What a design takes, before it is run: measures a few generations of each setting and derives the time, disk space
// and memory of all runs. Writes nothing.
#pragma once

#include "program/arguments.h"

namespace planula {

/// `planula run … --forecast`, with the same options. Throws Stopped.
int forecast(const Arguments &arguments, Console &console);

} // namespace planula
