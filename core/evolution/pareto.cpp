// SPDX-License-Identifier: MIT
#include "evolution/pareto.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace planula {

bool dominates(const Objectives &a, const Objectives &b) {
    if (a.empty() || b.empty()) return !a.empty() && b.empty();
    bool higher = false;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] < b[i]) return false;
        higher = higher || a[i] > b[i];
    }
    return higher;
}

std::vector<std::vector<int>> non_dominated_fronts(std::span<const Objectives> solutions) {
    const int count = static_cast<int>(solutions.size());
    std::vector<std::vector<int>> dominated(solutions.size());
    std::vector<int> dominators(solutions.size());
    for (int a = 0; a < count; ++a)
        for (int b = a + 1; b < count; ++b) {
            if (dominates(solutions[a], solutions[b])) dominated[a].push_back(b), ++dominators[b];
            if (dominates(solutions[b], solutions[a])) dominated[b].push_back(a), ++dominators[a];
        }

    // The next front: the solutions that only earlier fronts dominate.
    std::vector<std::vector<int>> fronts;
    std::vector<int> front;
    for (int i = 0; i < count; ++i)
        if (dominators[i] == 0) front.push_back(i);
    while (!front.empty()) {
        std::vector<int> next;
        for (const int leader : front)
            for (const int follower : dominated[leader])
                if (--dominators[follower] == 0) next.push_back(follower);
        std::sort(next.begin(), next.end());
        fronts.push_back(std::move(front));
        front = std::move(next);
    }
    return fronts;
}

std::vector<double> crowding_distances(std::span<const Objectives> solutions, std::span<const int> front) {
    std::vector<double> distances(front.size());
    if (front.empty()) return distances;
    const std::size_t objectives = solutions[front.front()].size();
    for (std::size_t objective = 0; objective < objectives; ++objective) {
        const auto value = [&](int place) { return solutions[front[place]][objective]; };
        std::vector<int> places(front.size());
        std::iota(places.begin(), places.end(), 0);
        std::stable_sort(places.begin(), places.end(), [&](int a, int b) { return value(a) < value(b); });

        const double range = value(places.back()) - value(places.front());
        for (const int end : {places.front(), places.back()})
            distances[end] = std::numeric_limits<double>::infinity();
        for (std::size_t i = 1; range > 0 && i + 1 < places.size(); ++i)
            distances[places[i]] += (value(places[i + 1]) - value(places[i - 1])) / range;
    }
    return distances;
}

} // namespace planula
