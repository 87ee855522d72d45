// SPDX-License-Identifier: MIT
// Counts of individuals over the whole history of a setting, in bins small enough to draw as a density: where the
// individuals of a run ended (Figure 9), and how fitness is distributed (Figure 11). Bins of generations are equally wide
// but for the last, and at most 60.
#pragma once

#include "analysis/tables.h"

#include <vector>

namespace planula {

/// How many viable individuals of a run ended where, by horizontal displacement, estimated from the sample that every
/// run records (experiment/sample.h), whatever else this one records. The bins of places are a power of two of cells
/// wide, the smallest from 1/8 with which 80 bins around 0 suffice. Empty bins have no row. Reads the run's individuals.
std::vector<EndpointDensityRow> endpoint_density_rows(const SettingRuns &setting,
                                                      const Representative &chosen);

/// The classes of fitness_share_rows() in every bin of generations.
std::vector<FitnessHistoryRow> fitness_history_rows(const SettingRuns &setting);

} // namespace planula
