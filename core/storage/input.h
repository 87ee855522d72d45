// SPDX-License-Identifier: MIT
// The one way by which planula reads a file: its bytes in order, plain or unpacked from gzip. A file that
// is not there, is damaged or cut off is an InputError; one that cannot be opened or read for another reason, which may
// pass, is an IoError.
#pragma once

#include <filesystem>
#include <string>

namespace planula {

class Input {
  public:
    explicit Input(std::filesystem::path path);
    ~Input();
    Input(const Input &) = delete;
    Input &operator=(const Input &) = delete;

    /// Fills the buffer; fewer than `size` bytes only at the end of the file.
    int read(char *buffer, int size);

  private:
    std::filesystem::path path_;
    void *stream_; // zlib's handle
    bool packed_;  // by its name
};

/// The whole content of a file; InputError above 1 GiB.
std::string read_file(const std::filesystem::path &path);

/// SHA-256 of the content of a file, after unpacking: what Output::commit() returned for it.
std::string content_sha256(const std::filesystem::path &path);

} // namespace planula
