// SPDX-License-Identifier: MIT
#include "program/overview.h"

#include "program/progress_file.h"

#include <algorithm>
#include <set>

namespace planula {

namespace {

namespace fs = std::filesystem;

/// The folders given as --out whose runs lie at or below this one, or which it lies in, and the folder itself.
std::set<fs::path> outs_of(const fs::path &folder) {
    std::set<fs::path> outs{folder};
    for (const fs::path &run : folders_with_runs(folder)) {
        const fs::path below = run.lexically_relative(folder);
        const bool is_deep = std::distance(below.begin(), below.end()) >= 2;
        outs.insert((is_deep ? run : fs::canonical(run)).parent_path().parent_path());
    }
    return outs;
}

/// Whether a run is the folder itself or lies below it.
bool is_within(const fs::path &run, const fs::path &folder) {
    const fs::path below = fs::weakly_canonical(run).lexically_relative(fs::weakly_canonical(folder));
    return !below.empty() && *below.begin() != "..";
}

} // namespace

Overview overview_of(const fs::path &asked) {
    const fs::path folder = asked.has_filename() ? asked : asked.parent_path(); // without a slash at its end
    Overview all;
    for (const fs::path &out : outs_of(folder)) {
        // A folder of one setting or of one run has only some of the runs.
        for (RunStatus &run : statuses(out))
            if (out == folder || is_within(run.folder, folder)) all.runs.push_back(std::move(run));
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
