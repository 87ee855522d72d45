// SPDX-License-Identifier: MIT
// The errors in a script, collected, each with the line of the script that states it.
#pragma once

#include "language/sources.h"
#include "language/value.h"

#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// A value's place in the result of a script: the table it is in, the way from there, and the way in
/// words ("settings[3].search") from the result or from the last table that knows its own line.
struct Place {
    Site site;
    std::vector<Step> path;
    std::string words;

    /// The place of an entry; a table that knows its own line starts there.
    Place at(const std::string &key, const Value *value = nullptr) const;
    Place at(int index, const Value *value = nullptr) const;
};

class Problems {
  public:
    explicit Problems(const Sources &sources) : sources_(sources) {}

    /// "file.lua:12", the line that states the value at a place.
    std::string line_of(const Place &place) const;
    /// The place of a script's result as a whole.
    Place root(const Value &result, const Source &script) const;
    void add(const Place &place, const std::string &message);
    /// A message that has its place already.
    void add(const std::string &message);
    std::size_t count() const { return messages_.size(); }
    /// Whether so many problems were found that further ones are not kept.
    bool is_full() const { return messages_.size() >= most; }
    /// Throws InputError with all messages, a line each; does nothing without messages.
    void raise() const;

  private:
    static constexpr std::size_t most = 100;
    const Sources &sources_;
    std::vector<std::string> messages_; // in the order found, each once
};

} // namespace planula
