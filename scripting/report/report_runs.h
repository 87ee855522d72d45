// SPDX-License-Identifier: MIT
// What a report is about: the complete runs at or below a folder, and the experiment that they are runs of.
#pragma once

#include "statement/schema.h"

#include <filesystem>
#include <string>
#include <vector>

namespace planula {

struct ReportRuns {
    RunChoice choice;                    // these runs, as reduce() takes them
    std::vector<std::string> settings;   // that the report is about; empty: all
    std::vector<RecordedRun> runs;       // by setting and seed
    std::vector<std::string> unfinished; // "folder: how far it is", of runs that are not complete
};

/// The runs in a folder, which is that of one run, of one setting, or of all runs of a design. Throws InputError if it
/// has no complete run, or runs of several designs.
ReportRuns report_runs(const std::filesystem::path &folder);

/// Leaves of an experiment these settings, or all if none is named, and the claims about them.
void keep_settings(Experiment &experiment, const std::vector<std::string> &names);

/// Asks of each setting as many generations as all its runs in `runs` have that are runs of the setting as the
/// experiment states it.
void ask_common_generations(Experiment &experiment, const std::vector<RecordedRun> &runs);

} // namespace planula
