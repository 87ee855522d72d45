// SPDX-License-Identifier: MIT
// What a report shows, as one object of JSON:
//
//   title, experiment, folder   texts
//   revision                    of the model of this program
//   confidence, interval_runs   of the intervals in the tables
//   tables                      by name, CSV: those of planula reduce that the page draws, and of each run's tables the
//                               rows and columns that it draws, each row behind the setting and seed of its run
//   dictionary                  columns.csv, of these tables
//   own                         names of the tables that the experiment makes itself
//   runs                        of each run setting, seed, folder and its manifest without the hashes of files
//   environments, departures    of each setting that has runs, as planula describe prints them
//   missing                     sentences: runs that are left out, or not complete
#pragma once

#include "report/report_runs.h"

#include <filesystem>
#include <string>
#include <vector>

namespace planula {

struct ReportSources {
    const Experiment &experiment;
    const ReportRuns &runs;
    std::filesystem::path tables;     // where reduce() wrote those of the runs
    std::filesystem::path library;    // of the paper's experiment
    std::vector<std::string> missing; // what reduce() told
};

/// A run in the report, with how many of its generations are shown.
struct ShownRun {
    const RecordedRun *run;
    int generations;
};

/// The runs that the tables are made of, by setting in the order of the experiment and by seed.
std::vector<ShownRun> shown_runs_of(const ReportSources &sources);

/// Throws InputError for damaged tables.
std::string report_data(const ReportSources &sources);

} // namespace planula
