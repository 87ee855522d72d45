// SPDX-License-Identifier: MIT
// The archive of a search as archive.csv.gz, the one table whose columns depend on the experiment: a
// descriptor of two numbers stands under x and y, any other under behaviour_1, behaviour_2, … Where the experiment names
// its numbers they stand under behaviour_<name>, and the objectives that it states follow under objective_<name>.
#pragma once

#include "evolution/search.h"
#include "tables/columns.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace planula {

/// The header for descriptors of this length, or for the named one of the aims, as a line.
std::string archive_header(std::size_t length = 2, const Aims &aims = {});
/// The line of an entry.
std::string archive_line(const ArchiveEntry &entry);

/// The first entries of a folder's archive, at most the given number.
std::vector<ArchiveEntry> read_archive(const std::filesystem::path &folder, std::size_t most = SIZE_MAX);
/// The same, of its journal.
std::vector<ArchiveEntry> read_archive_journal(const std::filesystem::path &folder, std::size_t most);

} // namespace planula
