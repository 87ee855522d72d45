// SPDX-License-Identifier: MIT
// The claims of the paper, judged on the runs there are: a test's verdict stands only if its data are all
// there, else the claim is open and a note says what is missing.
#pragma once

#include "analysis/analysis.h"
#include "analysis/survey.h"

#include <span>

namespace planula {

/// The number of generations at which a claim is looked at: its own, or as many as all its runs have; 0 if a
/// setting that it needs has no runs.
int generations_of(const Claim &claim, const Analysis &analysis, std::span<const SettingRuns> settings);

/// The claim's row. The histories have facts after generations_of() it.
ClaimRow judge_claim(const Claim &claim, const Analysis &analysis, std::span<const SettingRuns> settings);

} // namespace planula
