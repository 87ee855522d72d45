// SPDX-License-Identifier: MIT
#include "record/merge.h"

#include "base/error.h"
#include "base/text.h"
#include "record/chain.h"
#include "record/kept_state.h"
#include "record/run_folder.h"
#include "record/run_reader.h"
#include "storage/journal.h"
#include "storage/lines.h"
#include "storage/system.h"
#include "tables/csv.h"

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <linux/fs.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace planula {

namespace {

namespace fs = std::filesystem;

constexpr const char *incoming = ".incoming", *replaced = ".replaced";

fs::path beside(const fs::path &folder, const char *ending) {
    return folder.parent_path() / (folder.filename().string() + ending);
}

/// A run as a folder holds it: its identity, its chain, and its number of generations.
struct Part {
    RunRecord record;
    int complete = 0; // generations whose results are complete
    std::vector<std::string> links;
};

/// The newest checkpoint that is whole, its journals being as it says.
std::optional<KeptState> read_checkpoint(const fs::path &folder) {
    for (const fs::path &path : checkpoints(folder)) {
        std::optional<KeptState> kept = read_state(path);
        if (!kept) continue;
        for (const auto &[table, mark] : kept->tables) check_mark(journal_path(folder / table), mark);
        return kept;
    }
    return std::nullopt;
}

/// The links of chain.csv, or those of its journal if the newest checkpoint is further.
std::vector<std::string> read_links(const fs::path &folder, bool is_complete) {
    std::vector<std::string> links;
    if (is_complete)
        for (const ChainRow &row : read_chain(folder)) links.push_back(row.link);
    const std::optional<KeptState> kept = read_checkpoint(folder);
    if (!kept || kept->generation <= static_cast<int>(links.size())) return links;
    links.clear();
    Lines lines(journal_path(folder / ChainRow::file_name));
    lines.next();
    while (static_cast<int>(links.size()) < kept->generation && lines.next())
        links.push_back(lines.line().substr(lines.line().rfind(',') + 1));
    return links;
}

/// Nothing if no run has begun in the folder.
std::optional<Part> read_part(const fs::path &folder) {
    const std::optional<RunRecord> record = recorded_run(folder);
    if (!record) return std::nullopt;
    Part part{*record, complete_generations(folder), {}};
    if (part.complete > 0) check_files(open_run(folder));
    part.links = read_links(folder, part.complete > 0);
    return part;
}

/// Throws if the two are not one run whose shorter chain is the beginning of the longer one.
void check_agreement(const fs::path &from, const Part &a, const fs::path &into, const Part &b) {
    const auto refuse = [&](const std::string &why) {
        throw InputError(from.string() + " and " + into.string() + " contradict each other: " + why +
                         ". Nothing was changed.");
    };
    const auto lines = differences(b.record.identity, a.record.identity);
    if (!lines.empty()) refuse("they are different runs, " + lines.front());
    if (a.record.record != b.record.record)
        refuse("one is recorded as \"" + name_of(a.record.record) + "\", the other as \"" +
               name_of(b.record.record) + "\"");
    const std::size_t shared = std::min(a.links.size(), b.links.size());
    for (std::size_t i = 0; i < shared; ++i)
        if (a.links[i] != b.links[i])
            refuse("their chains differ from generation " + to_text(static_cast<std::int64_t>(i)));
}

/// Every file of a folder, each on disk.
void copy_folder(const fs::path &from, const fs::path &to) {
    fs::remove_all(to);
    make_folder(to);
    for (const fs::path &entry : all_below(from)) {
        const fs::path target = to / entry.lexically_relative(from);
        if (fs::is_directory(entry))
            make_folder(target);
        else if (entry.extension() != ".tmp")
            planula::copy_file(entry, target);
    }
    for (const fs::path &entry : all_below(to))
        if (fs::is_directory(entry)) sync_folder(entry);
    sync_folder(to);
}

/// Puts the folder that came in into the place of the one that is there: at once where the file system can, else by two
/// renames, which end_merges() completes.
void exchange(const fs::path &came, const fs::path &place) {
    const long done =
        ::syscall(SYS_renameat2, AT_FDCWD, came.c_str(), AT_FDCWD, place.c_str(), RENAME_EXCHANGE);
    if (done == 0) {
        sync_folder(place.parent_path());
        fs::remove_all(came);
        return;
    }
    const fs::path old = beside(place, replaced);
    if (std::rename(place.c_str(), old.c_str()) != 0) fail<IoError>("move", place, errno);
    if (std::rename(came.c_str(), place.c_str()) != 0) fail<IoError>("move", came, errno);
    sync_folder(place.parent_path());
    fs::remove_all(old);
}

} // namespace

Merged merge_run(const fs::path &from, const fs::path &into) {
    const FolderLock source(from);
    const std::optional<Part> part = read_part(from);
    if (!part) return Merged::known;
    make_folder(into.parent_path());
    std::optional<FolderLock> target;
    if (fs::is_directory(into)) target.emplace(into);
    const std::optional<Part> present = read_part(into);
    if (present) {
        check_agreement(from, *part, into, *present);
        if (part->links.size() <= present->links.size()) return Merged::known;
        // Complete results are replaced by complete ones alone.
        if (part->complete < present->complete) return Merged::unfinished;
    }
    const fs::path came = beside(into, incoming);
    copy_folder(from, came);
    if (!fs::exists(into)) {
        if (std::rename(came.c_str(), into.c_str()) != 0) fail<IoError>("move", came, errno);
        sync_folder(into.parent_path());
        return Merged::copied;
    }
    exchange(came, into);
    return present ? Merged::longer : Merged::copied;
}

void end_merges(const fs::path &setting) {
    if (!fs::exists(setting)) return;
    for (const fs::path &folder : entries_of(setting)) {
        const std::string ending = folder.extension().string();
        if (!fs::is_directory(folder) || (ending != incoming && ending != replaced)) continue;
        const fs::path place = folder.parent_path() / folder.stem();
        if (ending == replaced && !fs::exists(place)) {
            if (std::rename(folder.c_str(), place.c_str()) != 0) fail<IoError>("move", folder, errno);
        } else
            fs::remove_all(folder);
    }
}

} // namespace planula
