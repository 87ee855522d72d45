// SPDX-License-Identifier: MIT
// A search of core/evolution set on a benchmark, generation by generation, until the task is solved.
#pragma once

#include "benchmarks/task.h"

#include <cstdint>

namespace planula::benchmark {

struct Solution {
    bool solved;
    int generations;          // those begun
    std::int64_t evaluations; // attempts up to the first that solved the task; examinations are not counted
};

/// Runs the search named as in make_search() for at most the given number of generations. The result depends on its
/// arguments alone.
Solution solve(const Task &task, std::string_view search, const Parameters &parameters, std::uint64_t seed,
               int generations);

} // namespace planula::benchmark
