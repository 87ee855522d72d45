// SPDX-License-Identifier: MIT
#include "statement/line_diff.h"

#include <algorithm>

namespace planula {

std::vector<std::string> line_diff(std::span<const std::string> before, std::span<const std::string> after) {
    // common[i][j]: the most lines that before[i …] and after[j …] have in common.
    std::vector<std::vector<int>> common(before.size() + 1, std::vector<int>(after.size() + 1, 0));
    for (std::size_t i = before.size(); i-- > 0;)
        for (std::size_t j = after.size(); j-- > 0;)
            common[i][j] = before[i] == after[j] ? common[i + 1][j + 1] + 1
                                                 : std::max(common[i + 1][j], common[i][j + 1]);
    std::vector<std::string> lines;
    std::size_t i = 0, j = 0;
    while (i < before.size() || j < after.size()) {
        if (i < before.size() && j < after.size() && before[i] == after[j]) {
            lines.push_back("  " + before[i]);
            ++i, ++j;
        } else if (i < before.size() && (j == after.size() || common[i + 1][j] >= common[i][j + 1]))
            lines.push_back("- " + before[i++]);
        else
            lines.push_back("+ " + after[j++]);
    }
    return lines;
}

} // namespace planula
