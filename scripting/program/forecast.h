// SPDX-License-Identifier: MIT
// What a design costs, before it is paid: a few generations of each setting are measured here, and time, disk and memory
// of all runs follow from them. Writes nothing.
#pragma once

#include "program/arguments.h"

namespace planula {

/// `planula run … --forecast`, with the same options. Throws Stopped.
int forecast(const Arguments &arguments, Console &console);

} // namespace planula
