// SPDX-License-Identifier: MIT
#include "record/run_reader.h"

#include "base/error.h"
#include "base/text.h"
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

RecordedRun open_run(const std::filesystem::path &folder, const std::filesystem::path &runs,
                     const std::string &setting) {
    RecordedRun run{.folder = folder, .setting = setting, .manifest = Manifest(folder)};
    run.seed = run.manifest.number("seed");
    run.generations = count_of(run.manifest, folder, "generations");
    run.population = count_of(run.manifest, folder, "population");
    const std::string said = run.manifest.text("setting");
    if (said != setting || run.seed < 0 ||
        run_folder(runs, setting, static_cast<std::uint64_t>(run.seed)) != folder)
        throw InputError((folder / ManifestRow::file_name).string() + ": it is of the run '" + said +
                         "', seed " + to_text(run.seed) + ", which does not belong here");
    return run;
}

/// What `make` makes of the rows of a table of genomes; its errors name the file.
template <class Row, class Make> auto read_genomes(const RecordedRun &run, const Make &make) {
    const std::vector<Row> rows = read_table<Row>(run.folder);
    try {
        return make(rows);
    } catch (const InputError &error) {
        throw InputError((run.folder / Row::file_name).string() + ": " + error.what());
    }
}

} // namespace

std::vector<RecordedRun> find_runs(const std::filesystem::path &runs, const std::string &setting) {
    std::vector<RecordedRun> found;
    std::error_code error;
    for (const auto &entry : std::filesystem::directory_iterator(runs / setting, error)) {
        if (!std::filesystem::exists(entry.path() / ManifestRow::file_name)) continue;
        RecordedRun run = open_run(entry.path(), runs, setting);
        if (run.manifest.text("status") == "complete") found.push_back(std::move(run));
    }
    std::sort(found.begin(), found.end(),
              [](const RecordedRun &a, const RecordedRun &b) { return a.seed < b.seed; });
    return found;
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
    return read_genomes<GenomeRow>(run, [](const auto &rows) { return genome_of(rows); });
}

std::vector<Genome> read_last_population(const RecordedRun &run) {
    return read_genomes<PopulationRow>(run, [](const auto &rows) { return population_of(rows); });
}

} // namespace planula
