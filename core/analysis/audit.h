// SPDX-License-Identifier: MIT
// Whether a recorded run is what the model gives. Two questions: do its files agree with one another, which reading
// them answers in seconds, and are they what simulation gives, which costs as much as the part that is simulated again.
// A run is simulated again in stretches, each from one kept state to the next.
#pragma once

#include "experiment/run.h"
#include "record/run_reader.h"

#include <cstdint>
#include <vector>

namespace planula {

/// Throws InputError that names what is wrong first: a file whose content is not what the manifest says, the first
/// generation that is not as the chain has it, or a kept state of another run or place.
void check_consistency(const RecordedRun &run);

/// Generations first … last of a run, between two kept states or its ends.
struct Stretch {
    int first = 0, last = 0;
    int length() const { return last - first + 1; }
};

/// The stretches of a run, in order.
std::vector<Stretch> stretches(const RecordedRun &run);

/// Simulates a stretch again. Throws InputError that names the first generation which differs from the record, or the
/// kept state that follows if that does, and Stopped. The setting's functions must be fresh.
void recompute(const RecordedRun &run, const Spec &setting, const Stretch &stretch, const Workers &workers,
               const StopRequest &stop);

/// `count` numbers below `count`, each once, in an order that depends on the draw alone.
std::vector<int> drawn_order(int count, std::uint64_t draw);

} // namespace planula
