// SPDX-License-Identifier: MIT
#include "statistics/effect_size.h"

#include "statistics/summary.h"

#include <algorithm>
#include <vector>

namespace planula {

double a12(std::span<const double> a, std::span<const double> b) {
    check_sample(a);
    check_sample(b);
    std::vector<double> sorted(b.begin(), b.end());
    std::sort(sorted.begin(), sorted.end());

    // Half of what lies below plus half of what does not lie above: smaller ones once, equal ones half.
    double wins = 0;
    for (const double value : a) {
        const auto [low, high] = std::equal_range(sorted.begin(), sorted.end(), value);
        wins += 0.5 * static_cast<double>((low - sorted.begin()) + (high - sorted.begin()));
    }
    return wins / (static_cast<double>(a.size()) * static_cast<double>(b.size()));
}

double cliff_delta(std::span<const double> a, std::span<const double> b) { return 2 * a12(a, b) - 1; }

} // namespace planula
