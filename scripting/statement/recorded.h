// SPDX-License-Identifier: MIT
// The experiment that the folder of a run keeps.
#pragma once

#include "statement/schema.h"

#include <filesystem>

namespace planula {

/// The script in the folder of a run, with its modules and what the command line set beside it. Throws InputError.
Experiment recorded_experiment(const std::filesystem::path &folder, Part part = Part::all);

} // namespace planula
