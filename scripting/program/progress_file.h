// SPDX-License-Identifier: MIT
// What a running process says of itself to others: <out>/progress/<host>-<process>.csv, one row, rewritten every few
// seconds and removed at the end. `planula status` reads it. It is no result: whether it can be written decides nothing.
#pragma once

#include "program/progress.h"
#include "record/columns.h"

#include <filesystem>
#include <vector>

namespace planula {

class ProgressFile {
  public:
    /// Removes what processes of this machine that are no more have left.
    explicit ProgressFile(const std::filesystem::path &out);
    ~ProgressFile();
    ProgressFile(const ProgressFile &) = delete;
    ProgressFile &operator=(const ProgressFile &) = delete;

    void write(const Standing &standing) noexcept;

  private:
    std::filesystem::path folder_, path_;
};

/// What every process that works below a folder said of itself last: of another machine within ten minutes.
std::vector<ProgressRow> read_progress(const std::filesystem::path &out);

} // namespace planula
