// SPDX-License-Identifier: MIT
// How far all runs below a folder are, and the processes that work on them, as the files there say. Only reads.
#pragma once

#include "record/run_reader.h"
#include "tables/columns.h"

#include <cstdint>
#include <filesystem>
#include <map>
#include <vector>

namespace planula {

struct Overview {
    std::vector<RunStatus> runs;
    std::map<int, int> complete; // runs by the generations that are complete
    int unfinished = 0, unreadable = 0;
    std::int64_t evaluations = 0; // of complete generations and of those up to the checkpoint
    std::uintmax_t bytes = 0;
    std::vector<ProgressRow> processes;
    double rate = 0; // of all processes; 0: not known yet
    double seconds_left_level = 0, seconds_left = 0;
};

/// Throws InputError if there is no such folder.
Overview overview_of(const std::filesystem::path &folder);

} // namespace planula
