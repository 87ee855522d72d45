// SPDX-License-Identifier: MIT
// What `planula check` finds in a script that can be read: errors, with which no run can work, and warnings. Settings
// that share a fault share its finding.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace planula {

struct CheckFinding {
    bool is_error = false;
    std::string place; // "file.lua:12"
    std::string text;
    std::vector<std::string> settings; // that it holds for; empty: the script as a whole
};

class Findings {
  public:
    void add(const CheckFinding &finding);
    /// In the order in which they were found first.
    std::span<const CheckFinding> all() const { return all_; }
    bool has_errors() const;

  private:
    std::vector<CheckFinding> all_;
};

/// "file.lua:12: text (settings a, b)", the settings only if they are not all `count` of the script's.
std::string line_of(const CheckFinding &finding, std::size_t count);

} // namespace planula
