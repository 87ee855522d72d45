// SPDX-License-Identifier: MIT
// Recorded individuals simulated again: live() is a pure function, so a life that differs from the record in any
// bit is of another experiment or version.
#pragma once

#include "evaluation/live.h"
#include "experiment/spec.h"
#include "genome/genome.h"

#include <filesystem>

namespace planula {

/// The best individual of a setting or of a run, as recorded.
struct RecordedIndividual {
    std::filesystem::path file; // that says so, for errors
    Genome genome;
    double fitness = 0, displacement = 0;
    int cells = 0;
};

/// Simulates the individual again under the conditions of its setting. Throws InputError if its genome does not
/// fit the setting's actuation, or if it does not have the recorded displacement and cells.
Life simulate_again(const RecordedIndividual &recorded, const Spec &spec, const Watch &watch = {});

} // namespace planula
