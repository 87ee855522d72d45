// SPDX-License-Identifier: MIT
#include "record/complete_run.h"

#include "base/error.h"
#include "record/kept_state.h"
#include "record/resume_point.h"
#include "record/run_folder.h"
#include "storage/input.h"

#include <optional>
#include <utility>
#include <vector>

namespace planula {

namespace {

/// Removes the last state of a shorter run that became longer.
void remove_other_states(const CompleteRun &run) {
    for (const int generation : kept_generations(run.folder))
        if (!is_kept_at_end(generation, run.generations)) remove_file(state_path(run.folder, generation));
}

void write_manifest(const CompleteRun &run, const std::vector<std::pair<std::string, std::string>> &tables) {
    Manifest manifest;
    manifest.add("version", std::string(version()));
    manifest.add("compiler", compiler());
    manifest.add("identity", run.identity);
    manifest.add("setting", run.spec.name);
    manifest.add("seed", static_cast<std::int64_t>(run.seed));
    manifest.add("generations", run.generations);
    manifest.add("population", run.spec.parameters.neat.population);
    manifest.add("evaluations", std::int64_t{run.generations} * run.spec.parameters.neat.population);
    manifest.add("record", name_of(run.spec.record));
    manifest.add("link", run.link);
    const auto add_file = [&](const std::filesystem::path &path) {
        manifest.add(path.lexically_relative(run.folder).generic_string(), content_sha256(path));
    };
    add_file(run.folder / IdentityRow::file_name);
    for (const std::filesystem::path &path : script_files(run.folder)) add_file(path);
    for (const int generation : kept_generations(run.folder)) add_file(state_path(run.folder, generation));
    for (const auto &[file, hash] : tables) manifest.add(file, hash);
    manifest.seal();
    manifest.write(run.folder);
}

} // namespace

void complete_run(const CompleteRun &run, RunTables &tables) {
    // From here to the end there is no manifest; the journals hold everything.
    remove_file(run.folder / ManifestRow::file_name);
    const auto published = tables.publish();
    remove_other_states(run);
    write_manifest(run, published);

    // Only what is complete needs no journals any more.
    remove_journals(run.folder);
}

void remove_leftovers(const std::filesystem::path &folder, int complete) {
    if (!is_becoming_longer(folder, complete)) remove_journals(folder);
}

void tidy_complete_run(const std::filesystem::path &folder) {
    if (!has_journals(folder)) return;
    std::optional<FolderLock> lock;
    try {
        lock.emplace(folder);
    } catch (const RefusedError &) {
        return;
    }
    const int complete = complete_generations(folder);
    if (complete > 0) remove_leftovers(folder, complete);
}

} // namespace planula
