// SPDX-License-Identifier: MIT
// What a run can be measured by: every number of runs.csv, which sums a run up, and of generations.csv, as it was in
// the last generation. A name that both have is that of runs.csv: best_fitness is that of the run's champion.
#pragma once

#include "tables/columns.h"

#include <string>
#include <string_view>
#include <vector>

namespace planula {

struct Measure {
    std::string name, unit, meaning;

    /// The name in words.
    std::string words() const;
    /// The unit behind a number, with a blank before it; empty for numbers without one.
    std::string unit_words() const;
};

/// All of them, in the order of the tables.
std::vector<Measure> measures();

/// Throws InputError with the nearest name.
Measure measure_called(std::string_view name);

/// Its value in a run, given as a row of each table; none if that is empty.
Maybe measured(const Measure &measure, const RunRow &run, const GenerationRow &last);

} // namespace planula
