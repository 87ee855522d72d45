// SPDX-License-Identifier: MIT
// A gzip stream (RFC 1952) whose bytes depend on its content alone: fixed level, no time, no name in its header.
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace planula {

class Gzip {
  public:
    Gzip();
    ~Gzip();

    /// The compressed form of further bytes; `last` ends the stream.
    std::string compress(std::string_view bytes, bool last);

  private:
    struct Stream;
    std::unique_ptr<Stream> stream_;
};

/// A whole stream.
std::string gzipped(std::string_view content);

} // namespace planula
