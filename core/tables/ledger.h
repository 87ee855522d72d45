// SPDX-License-Identifier: MIT
// The ledger of parameters as a table: the value that an experiment has beside the paper's.
#pragma once

#include "parameters/parameters.h"
#include "tables/columns.h"

#include <span>
#include <vector>

namespace planula {

/// One row per parameter. The value is that of all these settings, and empty where they differ; there is at
/// least one setting.
std::vector<LedgerRow> ledger(std::span<const Parameters> settings);

} // namespace planula
