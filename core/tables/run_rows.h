// SPDX-License-Identifier: MIT
// A finished generation as rows of a run's tables (tables/columns.inl). Every row has the number of its generation in
// its first column. Means and sums run in slot order.
#pragma once

#include "experiment/run.h"
#include "tables/columns.h"

#include <vector>

namespace planula {

GenerationRow generation_row(const Generation &generation, const Parameters &parameters);
/// How many individuals with fitness there are of each size, by ascending size.
std::vector<SizeRow> size_rows(const Generation &generation);
/// How many individuals there are in each hundredth of the generation's highest fitness, by ascending class.
std::vector<FitnessClassRow> fitness_class_rows(const Generation &generation);
/// The species of every slot; -1 without a species.
std::vector<int> species_of_slots(const Population &population);
IndividualRow individual_row(const Generation &generation, int slot, int species);
SpeciesRow species_row(const Generation &generation, const Species &species);
/// The generation's best as the run's new champion.
ChampionRow champion_row(const Generation &generation, const Parameters &parameters);

} // namespace planula
