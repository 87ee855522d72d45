// SPDX-License-Identifier: MIT
// The lines of a file, plain or packed, one at a time and unchanged.
#pragma once

#include "storage/input.h"

#include <filesystem>
#include <string>
#include <vector>

namespace planula {

class Lines {
  public:
    explicit Lines(const std::filesystem::path &path) : input_(path), buffer_(std::size_t{1} << 16) {}

    /// Moves to the next line; false at the end. Throws as Input does.
    bool next();
    /// The present line, without its end.
    const std::string &line() const { return line_; }

  private:
    bool fill();

    Input input_;
    std::vector<char> buffer_;
    std::size_t at_ = 0, filled_ = 0;
    std::string line_;
};

} // namespace planula
