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

/// The claim's row, without the fields that depend on other claims. The histories have facts after generations_of() it.
ClaimRow judge_claim(const Claim &claim, const Analysis &analysis, std::span<const SettingRuns> settings);

/// Adds to the rows of an experiment its p-values corrected after Holm, over all of them, and by which p each verdict
/// is decided: by the corrected one if that is below the significance too, else by p alone.
void correct_claims(std::span<ClaimRow> rows, double significance);

} // namespace planula
