// SPDX-License-Identifier: MIT
// The directory of one run, <runs>/<setting>/seed-NNN/, as it is on disk:
//
//   identity.csv               what decides its genomes and lives, written before all else that it produces
//   script/                    the script that began it, its modules, and what the command line set beside them
//   <table>.part, checkpoint   while it is under way
//   states/                    kept states (record/kept_state.h); those before the last one may be removed
//   <table>, chain.csv         once it has come to an end
//   manifest.csv               written last: how long the run is, and the hash of every file
//
// A run that becomes longer keeps its tables and its manifest until the longer ones replace them. Nothing here is ever
// taken for another run: a folder belongs to the run that identity.csv names.
#pragma once

#include "experiment/identity.h"
#include "storage/output.h"
#include "tables/manifest.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planula {

/// The scripts that state a run, kept with it so that it can resume and be verified from its folder alone.
struct RunSources {
    struct File {
        std::string path;  // below script/
        std::string shown; // as messages call it
        std::string text;
    };
    std::vector<File> files;
    std::vector<std::pair<std::string, double>> overrides; // parameters set beside the script, in order
};

/// The folder of a run's scripts, and the name of the script in it.
std::filesystem::path script_folder(const std::filesystem::path &folder);
inline constexpr const char *script_file = "experiment.lua";

/// <runs>/<setting>/seed-NNN.
std::filesystem::path run_folder(const std::filesystem::path &runs, const std::string &setting,
                                 std::uint64_t seed);

/// What identity.csv says: who the run in a folder is, and how much of it is recorded.
struct RunRecord {
    Identity identity;
    Recording record;
};

/// Nothing if no run has begun in the folder, or there is no such folder. Throws RefusedError if the folder
/// holds something else, and InputError for a damaged record.
std::optional<RunRecord> recorded_run(const std::filesystem::path &folder);

/// Throws RefusedError, which says what differs and what to do, if the folder holds another run than this one, or
/// something that is no run. Changes nothing.
void check_same_run(const std::filesystem::path &folder, const RunRecord &asked);

/// Begins a run in a folder: writes its scripts, then identity.csv. Throws CreateError or IoError.
void begin_folder(const std::filesystem::path &folder, const RunRecord &run, const RunSources &sources);

/// The files of script/, by path.
std::vector<std::filesystem::path> script_files(const std::filesystem::path &folder);

/// Whether there are checkpoints or journals: the run is under way, or was killed.
bool has_journals(const std::filesystem::path &folder);

/// Removes what only a run that is under way needs: checkpoints, journals, and states that a killed process did not
/// finish.
void remove_journals(const std::filesystem::path &folder);

/// The manifest of a run that has come to an end; nothing without a manifest. Throws InputError if it is not what was
/// written, and IoError if it cannot be read.
std::optional<Manifest> recorded_manifest(const std::filesystem::path &folder);

/// Makes a folder for tables made of runs, and holds it for this process as long as the result exists. Throws
/// RefusedError if another process holds it, or if it is the folder of a run, whose files must not be replaced.
FolderLock hold_for_tables(const std::filesystem::path &out);

/// Whether a row of a run's manifest is the hash of a file: its key is a path.
bool is_file(std::string_view key);

/// Whether a run is whole without this file, which its manifest names: a kept state before the last one. Such states
/// only shorten what an audit or a replay simulates.
bool may_be_absent(const Manifest &manifest, std::string_view file);

/// How many kept states that the manifest names are not in the folder.
int absent_states(const std::filesystem::path &folder, const Manifest &manifest);

/// The generations of the run in this folder whose results are complete: 0 without a manifest. Throws InputError as
/// check_files_are_there() does.
int complete_generations(const std::filesystem::path &folder);

/// The generations of the run that are done, complete or only kept by a checkpoint.
int recorded_generations(const std::filesystem::path &folder);

/// Throws InputError that names a file which the manifest names and the folder lacks, unless it may be absent.
void check_files_are_there(const std::filesystem::path &folder, const Manifest &manifest);

} // namespace planula
