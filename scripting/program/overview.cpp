// SPDX-License-Identifier: MIT
#include "program/overview.h"

#include "program/progress_file.h"

#include <algorithm>
#include <set>

namespace planula {

namespace {

namespace fs = std::filesystem;

/// The folder itself, and every folder given as --out that has runs in it; or, if it lies in one, that one.
std::set<fs::path> outs_of(const fs::path &folder) {
    std::set<fs::path> outs{folder};
    for (const fs::path &run : folders_with_runs(folder)) outs.insert(run.parent_path().parent_path());
    return outs;
}

} // namespace

Overview overview_of(const fs::path &folder) {
    Overview all;
    std::error_code none;
    const fs::path whole = fs::canonical(folder, none);
    for (const fs::path &out : outs_of(none ? folder : whole)) {
        for (RunStatus &run : statuses(out)) {
            // A folder within --out, of one setting or one run, has only some of its runs.
            const fs::path below = run.folder.lexically_relative(whole);
            if (below.empty() || *below.begin() == "..") continue;
            run.folder = below == "." ? folder : folder / below;
            all.runs.push_back(std::move(run));
        }
        for (const ProgressRow &row : read_progress(out)) all.processes.push_back(row);
    }
    std::sort(all.runs.begin(), all.runs.end(),
              [](const RunStatus &a, const RunStatus &b) { return a.folder < b.folder; });
    for (const RunStatus &run : all.runs) {
        ++all.complete[run.complete];
        all.unfinished += run.kept > run.complete;
        all.unreadable += !run.trouble.empty();
        all.evaluations += std::int64_t{std::max(run.complete, run.kept)} * run.population;
        all.bytes += run.bytes;
    }
    // Processes work at the same time: the slowest determines the time left.
    for (const ProgressRow &row : all.processes) {
        all.rate += row.rate;
        all.seconds_left_level = std::max(all.seconds_left_level, row.seconds_left_level);
        all.seconds_left = std::max(all.seconds_left, row.seconds_left);
    }
    return all;
}

} // namespace planula
