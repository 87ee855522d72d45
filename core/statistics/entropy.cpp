// SPDX-License-Identifier: MIT
#include "statistics/entropy.h"

#include "base/math.h"
#include "statistics/demand.h"

#include <algorithm>
#include <vector>

namespace planula {

double entropy(std::span<const int> values) {
    std::vector<int> sorted(values.begin(), values.end());
    std::sort(sorted.begin(), sorted.end());
    std::vector<std::int64_t> counts;
    for (auto first = sorted.begin(); first != sorted.end();) {
        const auto next = std::upper_bound(first, sorted.end(), *first);
        counts.push_back(next - first);
        first = next;
    }
    return entropy_of_counts(counts);
}

double entropy_of_counts(std::span<const std::int64_t> counts) {
    std::int64_t total = 0;
    for (const std::int64_t count : counts) {
        demand(count >= 0, "a count is at least 0", static_cast<double>(count));
        total += count;
    }

    // Eq. (8), §3.6
    double H = 0;
    for (const std::int64_t count : counts) {
        if (count == 0) continue;
        const double p = static_cast<double>(count) / static_cast<double>(total);
        H -= p * math::log(p);
    }
    return H;
}

} // namespace planula
