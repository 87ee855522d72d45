// SPDX-License-Identifier: MIT
// Runs made up for trying out the statistics of an experiment before there are any: three of each setting, or fewer if
// fewer are planned. All values differ between runs and rise with the generations. The last run lacks every value that a
// run may lack. Nothing is random, no file is read.
#pragma once

#include "analysis/statistic.h"

#include <span>
#include <vector>

namespace planula {

/// As many generations as each setting asks for, and at least as many as are planned.
std::vector<SettingRuns> example_runs(std::span<const Spec> settings, const Parameters &planned);

/// These runs with end points and archives.
RunData example_data(const Analysis &analysis, std::span<const SettingRuns> examples);

} // namespace planula
