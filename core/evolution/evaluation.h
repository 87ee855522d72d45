// SPDX-License-Identifier: MIT
// What evolution is told about an individual. The evolution room knows genomes and evaluations, never an
// animat.
#pragma once

#include <vector>

namespace planula {

struct Evaluation {
    double fitness = 0;            // the objective, >= 0 and finite; in novelty search only recorded
    std::vector<double> behaviour; // the descriptor; the same length for every valid individual of a run
    double penalty = 0;            // p of Eq. 6, in [0, 1]; 0: the individual is not valid

    bool valid() const { return penalty > 0; }
};

} // namespace planula
