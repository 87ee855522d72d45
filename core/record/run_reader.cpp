// SPDX-License-Identifier: MIT
#include "record/run_reader.h"

#include "base/error.h"
#include "base/text.h"
#include "record/checkpoint.h"
#include "record/csv.h"
#include "record/genome_table.h"
#include "record/input.h"
#include "record/run_writer.h"

#include <algorithm>
#include <limits>

namespace planula {

namespace {

/// A count of a manifest: at least 1.
int count_of(const Manifest &manifest, const std::filesystem::path &folder, std::string_view key) {
    const std::int64_t value = manifest.number(key);
    if (value < 1 || value > std::numeric_limits<int>::max())
        throw InputError((folder / ManifestRow::file_name).string() + ": '" + std::string(key) +
                         "' = " + to_text(value) + " is not a count");
    return static_cast<int>(value);
}

RecordedRun open_run(const std::filesystem::path &folder) {
    RecordedRun run{.folder = folder, .manifest = Manifest(folder)};
    run.setting = run.manifest.text("setting");
    run.seed = run.manifest.number("seed");
    run.generations = count_of(run.manifest, folder, "generations");
    run.population = count_of(run.manifest, folder, "population");
    return run;
}

/// The folder must be that of the run which its manifest names.
void check_place(const RecordedRun &run, const std::filesystem::path &runs, const std::string &setting) {
    if (run.setting == setting && run.seed >= 0 &&
        run_folder(runs, setting, static_cast<std::uint64_t>(run.seed)) == run.folder)
        return;
    throw InputError((run.folder / ManifestRow::file_name).string() + ": it is of the run '" + run.setting +
                     "', seed " + to_text(run.seed) + ", which does not belong here");
}

bool is_complete(const RecordedRun &run) { return run.manifest.text("status") == "complete"; }

RunStatus status_of(const std::filesystem::path &folder) {
    if (std::filesystem::exists(folder / ManifestRow::file_name)) {
        const RecordedRun run = open_run(folder);
        if (is_complete(run)) return {folder, true, run.generations, run.generations};
    }
    const FoundCheckpoint found = find_checkpoint(folder);
    if (!found.checkpoint) return {folder};
    return {folder, false, found.checkpoint->generation, found.checkpoint->generations};
}

} // namespace

std::vector<RecordedRun> find_runs(const std::filesystem::path &runs, const std::string &setting) {
    std::vector<RecordedRun> found;
    std::error_code error;
    for (const auto &entry : std::filesystem::directory_iterator(runs / setting, error)) {
        if (!std::filesystem::exists(entry.path() / ManifestRow::file_name)) continue;
        RecordedRun run = open_run(entry.path());
        check_place(run, runs, setting);
        if (is_complete(run)) found.push_back(std::move(run));
    }
    std::sort(found.begin(), found.end(),
              [](const RecordedRun &a, const RecordedRun &b) { return a.seed < b.seed; });
    return found;
}

std::vector<RunStatus> statuses(const std::filesystem::path &runs) {
    if (!std::filesystem::is_directory(runs)) throw InputError(runs.string() + " is not a folder");
    std::vector<RunStatus> found;
    for (const auto &setting : std::filesystem::directory_iterator(runs)) {
        if (!setting.is_directory()) continue;
        for (const auto &entry : std::filesystem::directory_iterator(setting.path()))
            if (entry.is_directory() && entry.path().filename().string().starts_with("seed-"))
                found.push_back(status_of(entry.path()));
    }
    std::sort(found.begin(), found.end(),
              [](const RunStatus &a, const RunStatus &b) { return a.folder < b.folder; });
    return found;
}

RecordedRun read_run(const std::filesystem::path &folder) {
    if (!std::filesystem::exists(folder / ManifestRow::file_name))
        throw InputError(folder.string() + " is not the folder of a complete run: it has no " +
                         std::string(ManifestRow::file_name));
    RecordedRun run = open_run(folder);
    if (!is_complete(run)) throw InputError(folder.string() + " holds a run that is not complete");
    return run;
}

void verify(const RecordedRun &run) {
    for (const ManifestRow &row : run.manifest.rows()) {
        // A file's row has its name as the key.
        if (row.key.find('.') == std::string::npos) continue;
        const std::filesystem::path file = run.folder / std::filesystem::path(row.key).filename();
        if (content_sha256(file) != row.value)
            throw InputError(file.string() + ": its content is not what the run's manifest says");
    }
    if (results_sha256(run.manifest) != run.manifest.text("results_sha256"))
        throw InputError((run.folder / ManifestRow::file_name).string() +
                         ": the hashes of the files do not agree with results_sha256");
}

Genome read_best_genome(const RecordedRun &run) {
    const auto rows = read_table<GenomeRow>(run.folder);
    try {
        return genome_of(rows);
    } catch (const InputError &error) {
        throw InputError((run.folder / GenomeRow::file_name).string() + ": " + error.what());
    }
}

std::vector<Genome> read_last_population(const RecordedRun &run) {
    std::vector<Genome> genomes;
    for (NumberedGenome &each : read_numbered<PopulationRow>(run.folder)) {
        if (each.number != static_cast<int>(genomes.size()))
            throw InputError((run.folder / PopulationRow::file_name).string() + ": slot " +
                             to_text(static_cast<std::int64_t>(genomes.size())) + " is missing");
        genomes.push_back(std::move(each.genome));
    }
    return genomes;
}

} // namespace planula
