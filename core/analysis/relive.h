// SPDX-License-Identifier: MIT
// Individuals of a record, lived again: a life is a pure function, so what is not the recorded life to the
// last bit is of another experiment or version.
#pragma once

#include "evaluation/live.h"
#include "experiment/spec.h"
#include "genome/genome.h"

#include <filesystem>

namespace planula {

/// The best individual of a setting or of a run, as recorded.
struct Recorded {
    std::filesystem::path file; // that says so, for errors
    Genome genome;
    double fitness = 0, displacement = 0;
    int cells = 0;
};

/// Lives the individual again under the conditions of its setting. Throws InputError if its genome does not
/// fit the setting's actuation, or if it does not have the recorded displacement and cells.
Life relive(const Recorded &recorded, const Spec &spec, const Watch &watch = {});

} // namespace planula
