// SPDX-License-Identifier: MIT
#include "record/run_folder.h"

#include "base/check.h"
#include "base/error.h"
#include "base/text.h"
#include "record/kept_state.h"
#include "record/run_tables.h"
#include "storage/output.h"
#include "storage/system.h"
#include "tables/csv.h"

#include <algorithm>

namespace planula {

namespace {

constexpr const char *record_key = "record";
constexpr const char *advice = "\n  Give another --out, or move the folder away.";

/// What may lie in a folder whose run was stopped before it was named: nothing of it is a result.
bool is_before_identity(const std::filesystem::path &entry) {
    return entry.filename() == "script" || entry.extension() == ".tmp";
}

std::string joined(const std::vector<std::string> &lines) {
    std::string text;
    for (const std::string &line : lines) text += "\n    " + line;
    return text;
}

RunRecord read_identity(const std::filesystem::path &folder) {
    RunRecord run;
    Identity &identity = run.identity;
    TableReader<IdentityRow> reader(folder);
    bool has_record = false;
    for (IdentityRow row; reader.next(row);) {
        if (row.key == record_key) {
            const std::optional<Recording> record = record_of(row.value);
            if (!record) reader.refuse("'" + row.value + "' is neither full nor a sample");
            run.record = *record;
            has_record = true;
            continue;
        }
        if (identity.find(row.key)) reader.refuse("the key '" + row.key + "' is there twice");
        identity.items.push_back({row.key, row.value, row.place, row.standard});
    }
    if (!has_record || !identity.find("model") || !identity.find("seed"))
        reader.refuse("rows are missing at the end");
    return run;
}

/// A place in a file as messages call it, in the copy of that file below script/.
std::string place_in_copy(const std::string &place, const RunSources &sources) {
    const std::size_t colon = place.rfind(':');
    for (const RunSources::File &file : sources.files)
        if (colon != place.npos && file.shown == place.substr(0, colon))
            return file.path + place.substr(colon);
    return place;
}

/// The row that says how much is recorded comes last: with it the table is whole.
void write_identity(const std::filesystem::path &folder, const RunRecord &run, const RunSources &sources) {
    std::vector<IdentityRow> rows;
    for (const IdentityItem &item : run.identity.items)
        rows.push_back({item.key, item.value, place_in_copy(item.place, sources), item.standard});
    rows.push_back({record_key, name_of(run.record), "", ""});
    write_table<IdentityRow>(folder, rows);
}

} // namespace

std::filesystem::path script_folder(const std::filesystem::path &folder) { return folder / "script"; }

std::filesystem::path run_folder(const std::filesystem::path &runs, const std::string &setting,
                                 std::uint64_t seed) {
    CHECK(seed <= static_cast<std::uint64_t>(INT64_MAX), seed);
    constexpr std::size_t digits = 3;
    std::string number = to_text(static_cast<std::int64_t>(seed));
    if (number.size() < digits) number.insert(0, digits - number.size(), '0');
    return runs / setting / ("seed-" + number);
}

std::optional<RunRecord> recorded_run(const std::filesystem::path &folder) {
    if (!std::filesystem::exists(folder)) return std::nullopt;
    if (!std::filesystem::is_directory(folder))
        throw RefusedError(folder.string() + " is not a folder, so no run can be recorded there");
    if (std::filesystem::exists(folder / IdentityRow::file_name)) return read_identity(folder);
    for (const std::filesystem::path &entry : entries_of(folder))
        if (!is_before_identity(entry))
            throw RefusedError(folder.string() + " holds " + entry.filename().string() + " and no " +
                               std::string(IdentityRow::file_name) +
                               ": it is not a run of this planula, and is left as it is." + advice);
    return std::nullopt;
}

void check_same_run(const std::filesystem::path &folder, const RunRecord &asked) {
    const std::optional<RunRecord> recorded = recorded_run(folder);
    if (!recorded) return;
    const std::vector<std::string> lines = differences(recorded->identity, asked.identity);
    if (!lines.empty())
        throw RefusedError(folder.string() + " holds another run, which is left as it is:" + joined(lines) +
                           advice);
    if (recorded->record != asked.record)
        throw RefusedError(folder.string() + " holds this run with record = \"" + name_of(recorded->record) +
                           "\", and \"" + name_of(asked.record) + "\" is asked for; it is left as it is." +
                           advice);
}

void begin_folder(const std::filesystem::path &folder, const RunRecord &run, const RunSources &sources) {
    const std::filesystem::path scripts = script_folder(folder);
    std::filesystem::remove_all(scripts); // of a run that was killed before it was named
    make_folder(scripts);
    for (const RunSources::File &file : sources.files) {
        make_folder((scripts / file.path).parent_path());
        write_file(scripts / file.path, file.text);
    }
    std::vector<OverrideRow> rows;
    for (const auto &[name, value] : sources.overrides)
        rows.push_back({name, value_text(parameter_row(name), value)});
    write_table<OverrideRow>(scripts, rows);
    write_identity(folder, run, sources);
}

std::vector<std::filesystem::path> script_files(const std::filesystem::path &folder) {
    std::vector<std::filesystem::path> files;
    for (const std::filesystem::path &entry : all_below(script_folder(folder)))
        if (std::filesystem::is_regular_file(entry)) files.push_back(entry);
    std::sort(files.begin(), files.end());
    return files;
}

bool has_journals(const std::filesystem::path &folder) {
    const auto has_journal = [&](std::string_view file) {
        return std::filesystem::exists(journal_path(folder / file));
    };
    return !checkpoints(folder).empty() || std::any_of(run_tables.begin(), run_tables.end(), has_journal) ||
           has_journal(ChainRow::file_name);
}

void remove_journals(const std::filesystem::path &folder) {
    remove_checkpoints(folder);
    remove_unfinished_states(folder);
    for (const std::string_view file : run_tables) remove_file(journal_path(folder / file));
    remove_file(journal_path(folder / ChainRow::file_name));
}

std::optional<Manifest> recorded_manifest(const std::filesystem::path &folder) {
    const std::filesystem::path path = folder / ManifestRow::file_name;
    if (!std::filesystem::exists(path)) return std::nullopt;
    try {
        Manifest manifest(folder);
        manifest.check_seal();
        return manifest;
    } catch (const InputError &) {
        // A process that makes the run longer may have removed it meanwhile.
        if (std::filesystem::exists(path)) throw;
        return std::nullopt;
    }
}

int complete_generations(const std::filesystem::path &folder) {
    const std::optional<Manifest> manifest = recorded_manifest(folder);
    if (!manifest) return 0;
    check_files_are_there(folder, *manifest);
    return manifest->count("generations");
}

int recorded_generations(const std::filesystem::path &folder) {
    int generations = complete_generations(folder);
    for (const std::filesystem::path &path : checkpoints(folder)) {
        try {
            if (const std::optional<KeptState> kept = read_state(path))
                generations = std::max(generations, kept->generation);
        } catch (const InputError &) {
            // Another process is replacing it; or it is invalid, which resuming the run reports.
        }
    }
    return generations;
}

FolderLock hold_for_tables(const std::filesystem::path &out) {
    if (std::filesystem::exists(out / IdentityRow::file_name))
        throw RefusedError(out.string() +
                           " is the folder of a run, whose files would be replaced: give another --out");
    make_folder(out);
    return FolderLock(out);
}

bool is_file(std::string_view key) { return key.find('.') != std::string_view::npos; }

bool may_be_absent(const Manifest &manifest, std::string_view file) {
    const std::filesystem::path last = state_path({}, manifest.count("generations") - 1);
    return std::filesystem::path(file).parent_path() == last.parent_path() && file != last.generic_string();
}

int absent_states(const std::filesystem::path &folder, const Manifest &manifest) {
    return static_cast<int>(
        std::count_if(manifest.rows().begin(), manifest.rows().end(), [&](const ManifestRow &row) {
            return may_be_absent(manifest, row.key) && !std::filesystem::exists(folder / row.key);
        }));
}

void check_files_are_there(const std::filesystem::path &folder, const Manifest &manifest) {
    for (const ManifestRow &row : manifest.rows())
        if (is_file(row.key) && !may_be_absent(manifest, row.key) &&
            !std::filesystem::exists(folder / row.key))
            throw InputError(folder.string() + " lacks " + row.key +
                             ", which its manifest names: the folder is not whole. Nothing was changed. "
                             "Bring the file back, or "
                             "move the folder away to begin the run again.");
}

} // namespace planula
