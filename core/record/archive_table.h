// SPDX-License-Identifier: MIT
// The archive of novelty search as archive.csv, the one table whose columns depend on the experiment: a
// descriptor of two numbers stands under x and y, any other under behaviour_1, behaviour_2, …
#pragma once

#include "evolution/search.h"
#include "record/output.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace planula {

/// Writes archive.csv into a folder, entry by entry; all descriptors have one length.
class ArchiveWriter {
  public:
    explicit ArchiveWriter(const std::filesystem::path &folder);

    void write(const ArchiveEntry &entry);
    /// Puts the file under its name; returns the SHA-256 of its content.
    std::string commit();

  private:
    void begin(std::size_t length);

    Output output_;
    std::optional<std::size_t> length_; // of the descriptors, from the first entry on
};

std::vector<ArchiveEntry> read_archive(const std::filesystem::path &folder);

} // namespace planula
