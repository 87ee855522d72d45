// SPDX-License-Identifier: MIT
// The progress of a process, for other processes: <out>/progress/<host>-<process>.csv, one row, rewritten every few
// seconds and removed at the end. `planula status` reads it. It is not a result, and failing to write it is not an
// error.
#pragma once

#include "program/progress.h"
#include "tables/columns.h"

#include <filesystem>
#include <vector>

namespace planula {

class ProgressFile {
  public:
    /// Removes the files of processes of this machine that have ended.
    explicit ProgressFile(const std::filesystem::path &out);
    ~ProgressFile();
    ProgressFile(const ProgressFile &) = delete;
    ProgressFile &operator=(const ProgressFile &) = delete;

    void write(const Standing &standing) noexcept;

  private:
    std::filesystem::path folder_, path_;
};

/// The last row of every process that works below a folder; one of another machine counts for ten minutes.
std::vector<ProgressRow> read_progress(const std::filesystem::path &out);

} // namespace planula
