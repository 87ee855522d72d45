// SPDX-License-Identifier: MIT
// How much of a mother's fitness and size her children have: the columns children … cells_change of generations.csv
// (tables/columns.inl), which say what each is. Fitness is that of Eq. 4, whatever the search rewards.
#pragma once

#include "experiment/run.h"
#include "tables/columns.h"

namespace planula {

/// The least number of children, or of pairs, that a value is given for.
inline constexpr int least_pairs = 3;

/// Compares the children of a generation with their mothers.
void add_heredity(const Generation &generation, GenerationRow &row);

} // namespace planula
