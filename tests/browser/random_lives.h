// SPDX-License-Identifier: MIT
// Lives of random genomes (tests/support/hostile.h), apart from the specimens of the program, which have the same name.
#pragma once

#include "evaluation/conditions.h"
#include "genome/genome.h"

#include <optional>

namespace planula::test {

struct RandomLife {
    Genome genome;
    Conditions conditions;
};

/// Number 0, 1, …; none where a weight is not finite, which no genome of a run has.
std::optional<RandomLife> random_life(int number);

} // namespace planula::test
