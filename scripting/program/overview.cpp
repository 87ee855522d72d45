// SPDX-License-Identifier: MIT
#include "program/overview.h"

#include "program/progress_file.h"

#include <algorithm>

namespace planula {

Overview overview_of(const std::filesystem::path &folder) {
    Overview all;
    all.runs = statuses(folder);
    for (const RunStatus &run : all.runs) {
        ++all.complete[run.complete];
        all.unfinished += run.kept > run.complete;
        all.unreadable += !run.trouble.empty();
        all.evaluations += std::int64_t{std::max(run.complete, run.kept)} * run.population;
        all.bytes += run.bytes;
    }
    all.processes = read_progress(folder);
    // Processes work at the same time: the slowest determines the time left.
    for (const ProgressRow &row : all.processes) {
        all.rate += row.rate;
        all.seconds_left_level = std::max(all.seconds_left_level, row.seconds_left_level);
        all.seconds_left = std::max(all.seconds_left, row.seconds_left);
    }
    return all;
}

} // namespace planula
