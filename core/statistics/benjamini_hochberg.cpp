// SPDX-License-Identifier: MIT
#include "statistics/benjamini_hochberg.h"

#include "statistics/demand.h"

#include <algorithm>
#include <numeric>

namespace planula {

std::vector<double> benjamini_hochberg(std::span<const double> p) {
    for (const double value : p) demand(value >= 0 && value <= 1, "a p-value is from 0 to 1", value);
    std::vector<std::size_t> order(p.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });

    // The i-th smallest times the number of tests over i, from the largest down; none is above the one after.
    std::vector<double> corrected(p.size());
    double most = 1;
    for (std::size_t i = order.size(); i-- > 0;) {
        most = std::min(most, static_cast<double>(p.size()) / static_cast<double>(i + 1) * p[order[i]]);
        corrected[order[i]] = most;
    }
    return corrected;
}

} // namespace planula
