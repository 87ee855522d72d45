// SPDX-License-Identifier: MIT
// Runs as they lie on disk: which there are, and whether their files are still what their manifests say.
// Their tables are read by TableReader (record/csv.h), the archive by read_archive.
#pragma once

#include "genome/genome.h"
#include "record/manifest.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace planula {

struct RecordedRun {
    std::filesystem::path folder;
    std::string setting;
    std::int64_t seed = 0;
    int generations = 0, population = 0;
    Manifest manifest;
};

/// The complete runs of a setting, by ascending seed; none if there is no such folder. Throws InputError for
/// a manifest that is damaged or belongs to another place.
std::vector<RecordedRun> find_runs(const std::filesystem::path &runs, const std::string &setting);

/// The complete run in this folder. Throws InputError if there is none.
RecordedRun read_run(const std::filesystem::path &folder);

/// How far a run is.
struct RunStatus {
    std::filesystem::path folder;
    bool is_complete = false;
    int done = 0, generations = 0; // of an unfinished run as its checkpoint says; 0 without one
};

/// All runs below a folder, <folder>/<setting>/seed-NNN, by name. Throws InputError if there is no such folder,
/// or for a manifest or checkpoint that makes no sense.
std::vector<RunStatus> statuses(const std::filesystem::path &runs);

/// Throws InputError naming the first file whose content is not what the manifest says.
void verify(const RecordedRun &run);

/// The genome of the run's champion.
Genome read_best_genome(const RecordedRun &run);

/// The genomes of the run's last generation, in slot order.
std::vector<Genome> read_last_population(const RecordedRun &run);

} // namespace planula
