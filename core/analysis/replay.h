// SPDX-License-Identifier: MIT
// A recorded run simulated again from the nearest kept state: this gives every individual that was evaluated, and
// the record can be compared with the results of the model.
#pragma once

#include "experiment/run.h"
#include "record/run_reader.h"

#include <vector>

namespace planula {

/// Simulates the run from the newest kept state that is not after generation `first`, or from its beginning, and calls
/// observe(generation) for generations first … last, which the run must have, and observe_state(state) for the state
/// after each. The setting's functions must be fresh. Throws InputError for a damaged state, and Stopped.
void replay(
    const RecordedRun &run, const Spec &setting, int first, int last, const Workers &workers,
    const Observer &observe, const StopRequest &stop,
    const StateObserver &observe_state = [](const RunState &) {});

/// One individual of a run.
struct Individual {
    Genome genome;
    Life life;
    Evaluation evaluation;
    double score = 0;
};

/// The individual in a slot of a generation. Throws InputError if the run has none there, and if the generation that is
/// simulated is not the recorded one.
Individual replay_individual(const RecordedRun &run, const Spec &setting, int generation, int slot,
                             const Workers &workers, const StopRequest &stop);

} // namespace planula
