// SPDX-License-Identifier: MIT
// Sorting short records of small numbers without comparing any.
#pragma once

#include <array>
#include <cstddef>
#include <numeric>
#include <vector>

namespace planula {

/// Ascending by their first numbers, then the second and so on; all from 0 on and below `bound`.
template <std::size_t size> void counting_sort(std::vector<std::array<int, size>> &records, int bound) {
    // By one number after the other, from the last; records with equal numbers stay in their order.
    std::vector<std::array<int, size>> sorted(records.size());
    std::vector<int> place;
    for (std::size_t i = size; i-- > 0;) {
        place.assign(static_cast<std::size_t>(bound) + 1, 0);
        for (const auto &record : records) ++place[record[i] + 1];
        std::partial_sum(place.begin(), place.end(), place.begin());
        for (const auto &record : records) sorted[place[record[i]]++] = record;
        records.swap(sorted);
    }
}

} // namespace planula
