// SPDX-License-Identifier: MIT
#include "statistics/ranks.h"

#include "statistics/demand.h"
#include "statistics/summary.h"

#include <algorithm>
#include <numeric>

namespace planula {

bool is_exact(RankMethod method, std::size_t m, std::size_t n) {
    const std::size_t larger = std::max(m, n);
    if (method == RankMethod::exact)
        demand(larger <= exact_most, "an exact rank test takes at most 100 values of a sample",
               static_cast<double>(larger));
    return method == RankMethod::exact || (method == RankMethod::automatic && larger < exact_below);
}

std::vector<std::size_t> doubled(const Ranks &ranks) {
    std::vector<std::size_t> whole;
    for (const double rank : ranks.of) whole.push_back(static_cast<std::size_t>(2 * rank));
    std::sort(whole.begin(), whole.end());
    return whole;
}

Ranks ranks(std::span<const double> sample) {
    check_sample(sample);
    std::vector<std::size_t> order(sample.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sample[a] < sample[b]; });

    Ranks ranks{std::vector<double>(sample.size())};
    for (std::size_t first = 0; first < order.size();) {
        std::size_t next = first;
        while (next < order.size() && sample[order[next]] == sample[order[first]]) ++next;
        for (std::size_t i = first; i < next; ++i)
            ranks.of[order[i]] = static_cast<double>(first + 1 + next) / 2;
        const double tied = static_cast<double>(next - first);
        ranks.tie_cubes += tied * tied * tied - tied;
        first = next;
    }
    return ranks;
}

} // namespace planula
