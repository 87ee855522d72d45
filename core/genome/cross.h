// SPDX-License-Identifier: MIT
// Two parents, one child: crossover aligned by innovation (§2.7.1; decision 0013).
#pragma once

#include "base/random.h"
#include "genome/genome.h"

namespace planula {

struct Parent {
    const Genome &genome;
    double score; // before any sharing, boost or penalty
};

struct Crossing {
    bool averaging = false;    // matching weights are averaged, not chosen
    bool interspecies = false; // all disjoint and excess links of both parents are kept
    double weight_step = 0;    // averages are multiples of this; 0: any number
};

/// The child has every matching link, from either parent with equal chances or averaged, and the disjoint and excess
/// links of the fitter parent: the higher score, of equals the one with fewer links, of equals a coin. Its nodes are
/// the inputs, the outputs, and those its links need. Both parents must come from one run, and differ. The child
/// carries its parents' ids and no id of its own.
Genome cross(const Parent &mother, const Parent &father, const Crossing &crossing, Stream &stream);

} // namespace planula
