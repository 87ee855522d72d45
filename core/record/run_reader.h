// SPDX-License-Identifier: MIT
// Runs as they lie on disk (record/run_folder.h): which there are, how far they are, and whether their files are still
// what their manifests say. Their tables are read by TableReader (tables/csv.h), the archive by read_archive.
#pragma once

#include "experiment/run.h"
#include "genome/genome.h"
#include "record/run_folder.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace planula {

/// A complete run.
struct RecordedRun {
    std::filesystem::path folder;
    Identity identity;
    Recording record;
    std::string setting;
    std::int64_t seed = 0;
    int generations = 0, population = 0;
    Manifest manifest;
};

/// The runs of a setting by ascending seed, and of every other folder named like a run why it is left out.
struct FoundRuns {
    std::vector<RecordedRun> runs;
    std::vector<std::string> left_out; // "folder: reason"
};

/// The runs in <runs>/<setting>/ whose identity is that of the setting and that have at least the given number of
/// generations; none if there is no such folder. Throws InputError for a damaged record, and IoError for one that
/// cannot be read.
FoundRuns find_runs(const std::filesystem::path &runs, const Spec &setting, int generations);

/// The complete run in this folder. Throws InputError if the folder has no complete run.
RecordedRun open_run(const std::filesystem::path &folder);
/// The same, its files being what the manifest says.
RecordedRun read_run(const std::filesystem::path &folder);

/// How far a run is.
struct RunStatus {
    std::filesystem::path folder;
    int complete = 0;         // generations whose results are complete; 0: none
    int kept = 0;             // generations that the newest checkpoint has; 0: none
    int population = 0;       // 0 if unknown
    std::uintmax_t bytes = 0; // on disk
    std::string trouble;      // why it cannot be told how far the run is; empty
};

/// Every folder at or below this one in which a run has begun, or that has the name and the manifest of a run, by name.
/// Throws InputError if there is no such folder.
std::vector<std::filesystem::path> folders_with_runs(const std::filesystem::path &folder);

/// All runs below a folder, <folder>/<setting>/seed-NNN, by name. Throws InputError if there is no such folder.
std::vector<RunStatus> statuses(const std::filesystem::path &runs);

/// Throws InputError naming the first file whose content is not what the manifest says, or saying that another process
/// made the run longer meanwhile.
void check_files(const RecordedRun &run);

/// The genome of the champion after a number of generations. Throws InputError if the record has none.
Genome read_champion_genome(const RecordedRun &run, int generations);

/// The state before a generation of which states/ has a file. Throws InputError if that is damaged or of another run.
RunState read_run_state(const RecordedRun &run, const Spec &setting, int generation);

} // namespace planula
