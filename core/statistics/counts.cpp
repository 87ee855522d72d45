// SPDX-License-Identifier: MIT
#include "statistics/counts.h"

#include "statistics/demand.h"

#include <algorithm>
#include <vector>

namespace planula {

double hypergeometric_tail(int marked, int total, int all_marked, int drawn) {
    demand(total >= 0, "the total is at least 0", total);
    demand(drawn >= 0 && drawn <= total, "what is drawn is from 0 to the total", drawn);
    demand(all_marked >= 0 && all_marked <= total, "what is marked is from 0 to the total", all_marked);
    // Drawn one by one: chance[j] is that of j marked ones so far.
    std::vector<double> chance(static_cast<std::size_t>(drawn) + 1);
    chance[0] = 1;
    for (int i = 0; i < drawn; ++i)
        for (int j = i; j >= 0; --j) {
            const double marked_next = std::max(0, all_marked - j), left = total - i;
            chance[j + 1] += chance[j] * marked_next / left;
            chance[j] *= std::max(0.0, left - marked_next) / left;
        }
    double tail = 0;
    for (int j = drawn; j >= std::max(marked, 0); --j) tail += chance[j];
    return std::min(tail, 1.0);
}

double binomial_lower_tail(int found, int count, double probability) {
    demand(count >= 0, "the number of trials is at least 0", count);
    demand(probability >= 0 && probability <= 1, "a probability is from 0 to 1", probability);
    // One trial after the other: chance[j] is that of j successes so far.
    std::vector<double> chance(static_cast<std::size_t>(count) + 1);
    chance[0] = 1;
    for (int i = 0; i < count; ++i)
        for (int j = i; j >= 0; --j) {
            chance[j + 1] += chance[j] * probability;
            chance[j] *= 1 - probability;
        }
    double tail = 0;
    for (int j = 0; j <= std::min(found, count); ++j) tail += chance[j];
    return std::min(tail, 1.0);
}

} // namespace planula
