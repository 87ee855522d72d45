// SPDX-License-Identifier: MIT
#include "program/progress_file.h"

#include "base/error.h"
#include "base/text.h"
#include "tables/csv.h"

#include <cerrno>
#include <csignal>
#include <ctime>

#include <unistd.h>

namespace planula {

namespace {

constexpr std::int64_t seconds_valid = 600; // a generation of a large population may take minutes

std::string host() {
    char name[256] = "";
    ::gethostname(name, sizeof name - 1);
    return name;
}

/// The entries of a folder; none if it cannot be read.
std::vector<std::filesystem::path> entries_of(const std::filesystem::path &folder) {
    std::vector<std::filesystem::path> entries;
    std::error_code failure;
    for (std::filesystem::directory_iterator at(folder, failure), end; !failure && at != end;
         at.increment(failure))
        entries.push_back(at->path());
    return entries;
}

/// Whether the file belongs to a process of this machine that has ended.
bool is_stale(const std::filesystem::path &path) {
    const std::string name = path.filename().string(), own = host() + "-";
    if (!name.starts_with(own)) return false;
    const auto process = parse_int(name.substr(own.size(), name.find('.', own.size()) - own.size()));
    return process && ::kill(static_cast<pid_t>(*process), 0) != 0 && errno == ESRCH;
}

} // namespace

ProgressFile::ProgressFile(const std::filesystem::path &out)
    : folder_(out / "progress"),
      path_(folder_ / (host() + "-" + to_text(static_cast<int>(::getpid())) + ".csv")) {
    std::error_code ignored;
    for (const std::filesystem::path &path : entries_of(folder_))
        if (is_stale(path)) std::filesystem::remove(path, ignored);
    std::filesystem::remove(folder_, ignored); // if it is empty
}

ProgressFile::~ProgressFile() {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
    std::filesystem::remove(folder_, ignored); // if it is empty
}

void ProgressFile::write(const Standing &standing) noexcept {
    try {
        const ProgressRow row{.written = static_cast<std::int64_t>(std::time(nullptr)),
                              .level = standing.level,
                              .levels_left = standing.levels_left,
                              .runs = standing.runs,
                              .runs_done = standing.runs_done,
                              .evaluations = standing.evaluations,
                              .rate = standing.rate,
                              .seconds_left_level = standing.seconds_left_level,
                              .seconds_left = standing.seconds_left};
        make_folder(folder_);
        write_file(path_, header_line<ProgressRow>() + line_of(row));
    } catch (const std::exception &) {
        // planula status then does not show this process.
    }
}

std::vector<ProgressRow> read_progress(const std::filesystem::path &out) {
    std::vector<ProgressRow> rows;
    const auto now = static_cast<std::int64_t>(std::time(nullptr));
    for (const std::filesystem::path &path : entries_of(out / "progress")) {
        if (is_stale(path) || path.extension() != ".csv") continue;
        try {
            TableReader<ProgressRow> reader(path, header_of<ProgressRow>());
            ProgressRow row;
            if (reader.next(row) && now - row.written <= seconds_valid) rows.push_back(row);
        } catch (const Error &) {
            // The file was removed, or is not such a table.
        }
    }
    return rows;
}

} // namespace planula
