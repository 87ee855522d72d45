// SPDX-License-Identifier: MIT
// The claims of an experiment, judged on the runs there are: the verdict of a claim's function stands only if its data
// are all there, else the claim is open and a note says what is missing.
#pragma once

#include "analysis/statistic.h"

#include <span>

namespace planula {

/// The claim's row, without the fields that depend on other claims.
ClaimRow judge_claim(const Claim &claim, const RunData &data);

/// Adds to the rows of an experiment its p-values corrected after Holm, over all of them, and by which p each verdict
/// is decided: by the corrected one if that is below the significance too, else by p alone.
void correct_claims(std::span<ClaimRow> rows, double significance);

} // namespace planula
