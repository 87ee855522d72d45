// SPDX-License-Identifier: MIT
#include "statistics/holm.h"

#include "statistics/demand.h"

#include <algorithm>
#include <numeric>

namespace planula {

std::vector<double> holm(std::span<const double> p) {
    for (const double value : p) demand(value >= 0 && value <= 1, "a p-value is from 0 to 1", value);
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });

    // The smallest times the number of tests, the next times one less, and so on; none is below the one before.
    std::vector<double> corrected(p.size());
    double least = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        least = std::max(least, std::min(1.0, static_cast<double>(p.size() - i) * p[order[i]]));
        corrected[order[i]] = least;
    }
    return corrected;
}

} // namespace planula
