// SPDX-License-Identifier: MIT
#include "record/run_reader.h"

#include "base/error.h"
#include "base/text.h"
#include "experiment/run_state.h"
#include "record/kept_state.h"
#include "storage/input.h"
#include "storage/system.h"
#include "tables/archive_table.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <algorithm>

namespace planula {

namespace {

std::int64_t seed_of(const Identity &identity, const std::filesystem::path &folder) {
    const auto seed = parse_int(*identity.find("seed"));
    if (!seed || *seed < 0)
        throw InputError((folder / IdentityRow::file_name).string() +
                         ": the seed is not a whole number of 0 or more");
    return *seed;
}

RecordedRun open_run(const std::filesystem::path &folder, const RunRecord &record, Manifest manifest) {
    RecordedRun run{.folder = folder,
                    .identity = record.identity,
                    .record = record.record,
                    .setting = manifest.text("setting"),
                    .seed = seed_of(record.identity, folder),
                    .generations = manifest.count("generations"),
                    .population = manifest.count("population"),
                    .manifest = std::move(manifest)};
    if (run.manifest.text("identity") != run.identity.sha256() || run.manifest.number("seed") != run.seed)
        throw InputError((folder / ManifestRow::file_name).string() + ": it is of another run than " +
                         std::string(IdentityRow::file_name));
    return run;
}

/// seed-NNN, as run_folder() makes it.
bool is_run_name(const std::filesystem::path &folder) {
    const std::string name = folder.filename().string(), start = "seed-";
    return name.starts_with(start) && parse_int(name.substr(start.size())).value_or(-1) >= 0;
}

/// Every folder below <runs>/<setting> that is named like a run, by name; empty without such a folder.
std::vector<std::filesystem::path> run_folders(const std::filesystem::path &setting) {
    std::vector<std::filesystem::path> folders;
    if (!std::filesystem::exists(setting)) return folders;
    for (const std::filesystem::path &entry : entries_of(setting))
        if (std::filesystem::is_directory(entry) && is_run_name(entry)) folders.push_back(entry);
    return folders;
}

/// Adds the run in a folder to those found, or the reason why it is left out.
void add_run(const std::filesystem::path &runs, const std::filesystem::path &folder, const Spec &setting,
             int generations, FoundRuns &found) {
    const auto leave_out = [&](const std::string &why) {
        found.left_out.push_back(folder.string() + ": " + why);
    };
    std::optional<RunRecord> record;
    try {
        record = recorded_run(folder);
    } catch (const CreateError &) {
        return leave_out("not a run of this planula");
    }
    if (!record) return leave_out("no run has begun there");
    const std::int64_t seed = seed_of(record->identity, folder);
    if (run_folder(runs, setting.name, static_cast<std::uint64_t>(seed)) != folder)
        return leave_out("it is a run of seed " + to_text(seed) + ", which does not belong there");
    const auto lines = differences(record->identity, identity_of(setting, static_cast<std::uint64_t>(seed)));
    if (!lines.empty())
        return leave_out("another run: " + lines.front() +
                         (lines.size() > 1
                              ? " (and " + to_text(static_cast<std::int64_t>(lines.size()) - 1) + " more)"
                              : ""));
    std::optional<Manifest> manifest = recorded_manifest(folder);
    if (!manifest) return leave_out("not complete");
    RecordedRun run = open_run(folder, *record, std::move(*manifest));
    if (run.generations < generations)
        return leave_out(to_text(run.generations) + " generations, where " + to_text(generations) +
                         " are asked for");
    found.runs.push_back(std::move(run));
}

/// Files may come and go meanwhile.
std::uintmax_t bytes_below(const std::filesystem::path &folder) {
    std::uintmax_t bytes = 0;
    std::error_code failure;
    std::filesystem::recursive_directory_iterator at(folder, failure);
    for (const std::filesystem::recursive_directory_iterator end; !failure && at != end;
         at.increment(failure)) {
        std::error_code gone;
        if (at->is_regular_file(gone)) {
            const std::uintmax_t size = at->file_size(gone);
            if (!gone) bytes += size;
        }
    }
    return bytes;
}

RunStatus status_now(const std::filesystem::path &folder) {
    RunStatus status{.folder = folder, .bytes = bytes_below(folder)};
    try {
        const std::optional<RunRecord> record = recorded_run(folder);
        if (!record) return status;
        if (const std::string *population = record->identity.find("parameter population"))
            status.population = static_cast<int>(parse_double(*population).value_or(0)); // may be 1e+05
        status.complete = complete_generations(folder);
        for (const std::filesystem::path &path : checkpoints(folder)) {
            const std::optional<KeptState> kept = read_state(path);
            if (kept) status.kept = std::max(status.kept, kept->generation);
        }
    } catch (const Error &error) {
        status.trouble = error.what();
    } catch (const std::filesystem::filesystem_error &error) {
        status.trouble = error.what();
    }
    return status;
}

void compare_files(const RecordedRun &run) {
    check_files_are_there(run.folder, run.manifest);
    for (const ManifestRow &row : run.manifest.rows()) {
        if (!is_file(row.key)) continue;
        if (may_be_absent(run.manifest, row.key) && !std::filesystem::exists(run.folder / row.key)) continue;
        if (content_sha256(run.folder / row.key) != row.value)
            throw InputError((run.folder / row.key).string() +
                             ": its content is not what the run's manifest says");
    }
}

/// Whether the manifest is no longer that which was read, as when another process made the run longer.
bool became_longer(const RecordedRun &run) {
    try {
        const std::optional<Manifest> now = recorded_manifest(run.folder);
        return !now || now->text("link") != run.manifest.text("link");
    } catch (const InputError &) {
        return false;
    }
}

/// Files that another process replaces at this moment are read a second time.
RunStatus status_of(const std::filesystem::path &folder) {
    RunStatus status = status_now(folder);
    for (int again = 0; again < 2 && !status.trouble.empty(); ++again) status = status_now(folder);
    return status;
}

} // namespace

FoundRuns find_runs(const std::filesystem::path &runs, const Spec &setting, int generations) {
    FoundRuns found;
    for (const std::filesystem::path &folder : run_folders(runs / setting.name))
        add_run(runs, folder, setting, generations, found);
    std::sort(found.runs.begin(), found.runs.end(),
              [](const RecordedRun &a, const RecordedRun &b) { return a.seed < b.seed; });
    return found;
}

std::vector<std::filesystem::path> folders_with_runs(const std::filesystem::path &folder) {
    if (!std::filesystem::is_directory(folder)) throw InputError(folder.string() + " is not a folder");
    std::vector<std::filesystem::path> folders;
    const auto look = [&](const std::filesystem::path &path) {
        const bool is_run = std::filesystem::exists(path / IdentityRow::file_name) ||
                            (is_run_name(path) && std::filesystem::exists(path / ManifestRow::file_name));
        if (is_run) folders.push_back(path);
    };
    look(folder);
    for (const std::filesystem::path &entry : all_below(folder))
        if (std::filesystem::is_directory(entry)) look(entry);
    std::sort(folders.begin(), folders.end());
    return folders;
}

std::vector<RunStatus> statuses(const std::filesystem::path &runs) {
    if (!std::filesystem::is_directory(runs)) throw InputError(runs.string() + " is not a folder");
    std::vector<RunStatus> found;
    for (const std::filesystem::path &setting : entries_of(runs)) {
        if (!std::filesystem::is_directory(setting)) continue;
        for (const std::filesystem::path &folder : run_folders(setting)) found.push_back(status_of(folder));
    }
    std::sort(found.begin(), found.end(),
              [](const RunStatus &a, const RunStatus &b) { return a.folder < b.folder; });
    return found;
}

RecordedRun open_run(const std::filesystem::path &folder) {
    std::optional<RunRecord> record;
    std::optional<Manifest> manifest;
    if (std::filesystem::exists(folder / IdentityRow::file_name)) record = recorded_run(folder);
    if (record) manifest = recorded_manifest(folder);
    if (!manifest)
        throw InputError(folder.string() + " is not the folder of a complete run: it has no " +
                         std::string(record ? ManifestRow::file_name : IdentityRow::file_name));
    return open_run(folder, *record, std::move(*manifest));
}

RecordedRun read_run(const std::filesystem::path &folder) {
    RecordedRun run = open_run(folder);
    check_files(run);
    return run;
}

void check_files(const RecordedRun &run) {
    try {
        compare_files(run);
    } catch (const Error &) {
        if (!became_longer(run)) throw;
        throw InputError(run.folder.string() +
                         ": another process makes this run longer at the moment. Give the command again.");
    }
}

Genome read_champion_genome(const RecordedRun &run, int generations) {
    std::optional<Genome> genome;
    for (NumberedGenome &champion : read_numbered<ChampionGenomeRow>(run.folder))
        if (champion.number < generations) genome = std::move(champion.genome);
    if (!genome)
        throw InputError((run.folder / ChampionGenomeRow::file_name).string() + ": there is no champion");
    return std::move(*genome);
}

RunState read_run_state(const RecordedRun &run, const Spec &setting, int generation) {
    const std::filesystem::path path = state_path(run.folder, generation);
    const std::optional<KeptState> kept = read_state(path);
    if (!kept) throw InputError(path.string() + ": the file is damaged");
    if (kept->identity != run.identity.sha256())
        throw InputError(path.string() + ": it is a state of another run");
    const auto archive = kept->archive > 0 ? read_archive(run.folder, static_cast<std::size_t>(kept->archive))
                                           : std::vector<ArchiveEntry>();
    Spec spec = setting;
    spec.parameters.design.generations = run.generations;
    try {
        StateReader reader(kept->state);
        RunState state = load_run_state(spec, archive, reader);
        reader.done();
        if (kept->generation != generation || state.population.generation != generation)
            reader.refuse("it is of another generation");
        return state;
    } catch (const InputError &error) {
        throw InputError(path.string() + ": " + error.what());
    }
}

} // namespace planula
