// SPDX-License-Identifier: MIT
// One evolutionary run, generation by generation: individuals are simulated and judged, and the search makes the next
// population. The run writes no file and prints nothing; it hands every finished generation to an observer. Between two
// generations a run is its RunState and nothing else, so that it may stop there and resume in another process.
#pragma once

#include "evaluation/memo.h"
#include "evolution/search.h"
#include "experiment/lives.h"
#include "experiment/mothers.h"

#include <cstdint>
#include <functional>
#include <memory>
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
    /// Of this population.
    const Mothers &mothers;
    /// Slot of the highest fitness; the lowest slot of equals.
    int best;
    /// How many of the lives were known from the generation before and not simulated; no result.
    Known known;
};

/// A run between two generations: the population to simulate next, the search after the generations before, and what
/// the mothers of this population, and all that may become one, did.
struct RunState {
    Population population;
    std::unique_ptr<Search> search;
    Mothers mothers;
};

using Observer = std::function<void(const Generation &)>;
/// Shown the state after each generation but the last.
using StateObserver = std::function<void(const RunState &)>;

/// The state before generation 0. Where the setting evolves that one first, this takes time and may end with
/// Stopped.
RunState begin(
    const Spec &spec, std::uint64_t seed, const Workers &workers = 1,
    const StopRequest &stop = [] { return false; });

/// Runs the setting's generations from this state on. The results depend on (spec, seed) alone, not on the workers, nor
/// on where the run was resumed. If it throws Stopped, the state is the one before the generation that was abandoned.
void run(
    const Spec &spec, std::uint64_t seed, const Workers &workers, RunState &state, const Observer &observe,
    const StateObserver &observe_state = [](const RunState &) {},
    const StopRequest &stop = [] { return false; });

/// Runs all generations.
void run(
    const Spec &spec, std::uint64_t seed, const Workers &workers, const Observer &observe,
    const StopRequest &stop = [] { return false; });

} // namespace planula
