// SPDX-License-Identifier: MIT
// The calls of the system that writers share, each checked: errors name the file and the reason.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace planula {

/// Throws an error of this kind: "cannot <what> <path>: <reason of the system's error number>".
template <class Kind>
[[noreturn]] void fail(const std::string &what, const std::filesystem::path &path, int number) {
    throw Kind("cannot " + what + " " + path.string() + ": " + std::generic_category().message(number));
}

/// Writes all bytes to an open file. Throws IoError that names `path`.
void write_all(int file, std::string_view bytes, const std::filesystem::path &path);

/// Waits until the content of an open file is on disk. Throws IoError that names `path`.
void sync_file(int file, const std::filesystem::path &path);

/// The entries of a folder, by name. Throws IoError that names the folder.
std::vector<std::filesystem::path> entries_of(const std::filesystem::path &folder);

/// Everything below a folder, each folder before its entries. Throws IoError that names the folder.
std::vector<std::filesystem::path> all_below(const std::filesystem::path &folder);

/// Waits until the entries of a folder are on disk. Throws IoError.
void sync_folder(const std::filesystem::path &folder);

} // namespace planula
