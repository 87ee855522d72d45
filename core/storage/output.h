// SPDX-License-Identifier: MIT
// The one way by which planula writes a file. The bytes go to a temporary beside the target; commit() flushes
// and syncs it, renames it to its name and syncs the folder, so that under the name there is either the whole
// new content or what was there before. Every call of the system is checked: CreateError if the target cannot
// be made, IoError if writing fails on the way, both naming the target and the reason.
//
// A name that ends in .gz is compressed with the same bytes for the same content: fixed level, no time, no
// name in its header.
#pragma once

#include "base/hash.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace planula {

class Gzip;

class Output {
  public:
    explicit Output(std::filesystem::path path);
    /// Without commit() the temporary is removed and the target is what it was.
    ~Output();
    Output(const Output &) = delete;
    Output &operator=(const Output &) = delete;

    void write(std::string_view bytes);
    /// Makes the target appear. Returns the SHA-256 of its content, before compression.
    std::string commit();

    const std::filesystem::path &path() const { return path_; }

  private:
    void flush(bool last);

    std::filesystem::path path_, temporary_;
    int file_ = -1;
    std::string pending_;        // at most a buffer full of the content
    std::unique_ptr<Gzip> gzip_; // none: plain text
    Hash hash_;
};

/// Writes a whole file; returns the SHA-256 of its content.
std::string write_file(const std::filesystem::path &path, std::string_view content);

/// Copies the bytes of a file into a new one and waits until they are on disk. Throws IoError or CreateError.
void copy_file(const std::filesystem::path &from, const std::filesystem::path &to);

/// Makes a folder and those above it. Throws CreateError.
void make_folder(const std::filesystem::path &folder);

/// Removes a file if it is there, and syncs the folder. Throws IoError.
void remove_file(const std::filesystem::path &path);

/// Holds a folder for this process as long as the object lives; the lock dies with the process.
class FolderLock {
  public:
    /// Throws RefusedError if another process holds it, and CreateError if it cannot be held.
    explicit FolderLock(const std::filesystem::path &folder);
    ~FolderLock();
    FolderLock(const FolderLock &) = delete;
    FolderLock &operator=(const FolderLock &) = delete;

  private:
    int file_;
};

} // namespace planula
