// SPDX-License-Identifier: MIT
// Two texts line by line: what is common to them, in the longest way, and what is not.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace planula {

/// The lines of both, each behind "  " (in both), "- " (in the first alone) or "+ " (in the second alone); of two
/// replaced parts the first's lines come first. Takes time and memory for the product of the lengths.
std::vector<std::string> line_diff(std::span<const std::string> before, std::span<const std::string> after);

} // namespace planula
