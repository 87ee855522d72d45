// SPDX-License-Identifier: MIT
// Where a genome came from: the line of its mothers, back to generation 0, as the run's individuals tell it.
#pragma once

#include "record/run_reader.h"
#include "tables/columns.h"

#include <cstdint>
#include <vector>

namespace planula {

/// The genome and its mothers, the oldest first. Ancestors that are unchanged copies of their mothers
/// (champion, filler, clone) are left out unless asked for; the genome itself never is. Throws InputError if
/// the run never had such a genome, or its record is not that of a run.
std::vector<LineageRow> lineage(const RecordedRun &run, std::int64_t genome, bool with_copies);

} // namespace planula
