// SPDX-License-Identifier: MIT
// Key and value rows that say what a folder of tables is: manifest.csv of a run and of the reduced data.
#pragma once

#include "tables/columns.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// The version of planula, as CMake's project() states it.
std::string_view version();
/// The compiler that built this program, with its version. It reaches no result.
std::string compiler();

class Manifest {
  public:
    Manifest() = default;
    /// Reads manifest.csv of a folder; InputError for a key that is there twice.
    explicit Manifest(const std::filesystem::path &folder);

    void add(std::string key, std::string value);
    void add(std::string key, std::int64_t value);
    /// Writes manifest.csv into a folder.
    void write(const std::filesystem::path &folder) const;
    /// Adds a last row with the hash of all others.
    void seal();
    /// Throws InputError if the last row is not the hash of all others: a row was changed.
    void check_seal() const;

    bool has(std::string_view key) const { return find(key) != nullptr; }
    /// Throws InputError if there is no such key, or, for a number, if its value is not one.
    const std::string &text(std::string_view key) const;
    std::int64_t number(std::string_view key) const;
    /// A number of 1 or more that fits an int. Throws InputError.
    int count(std::string_view key) const;
    const std::vector<ManifestRow> &rows() const { return rows_; }

  private:
    const std::string *find(std::string_view key) const;
    std::string hash_of_rows(std::size_t count) const;
    [[noreturn]] void refuse(const std::string &what) const;

    std::filesystem::path folder_;
    std::vector<ManifestRow> rows_;
};

} // namespace planula
