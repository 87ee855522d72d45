// SPDX-License-Identifier: MIT
// Where life and search meet: one evolutionary run, generation by generation. The run writes no file and
// prints nothing; it hands every finished generation to an observer.
#pragma once

#include "evolution/search.h"
#include "experiment/spec.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace planula {

/// A finished generation, in slot order; valid only while the observer runs.
struct Generation {
    int number;
    const Population &population;
    std::span<const Life> lives;
    std::span<const Evaluation> evaluations;
    std::span<const double> scores;
    const Search &search;
    /// Slot of the highest fitness; the lowest slot of equals.
    int best;
};

using Observer = std::function<void(const Generation &)>;
/// Asked before each generation and between evaluations; true ends the run with Stopped.
using StopRequest = std::function<bool()>;

/// Runs all generations of the setting. The results depend on (spec, seed) alone, not on `threads`.
void run(
    const Spec &spec, std::uint64_t seed, int threads, const Observer &observe,
    const StopRequest &stop = [] { return false; });

} // namespace planula
