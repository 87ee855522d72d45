// SPDX-License-Identifier: MIT
// What a statistic of an experiment is given, and what it says: a claim's verdict, or the rows of a table (decision
// 0023). The function itself is the experiment's; nothing here knows the language in which it is written.
#pragma once

#include "analysis/analysis.h"
#include "analysis/survey.h"
#include "evolution/search.h"

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace planula {

/// The runs that statistics read. Several threads may read them at the same time.
struct RunData {
    const Analysis &analysis;
    std::span<const SettingRuns> settings; // with their histories
    /// Where viable individuals of the sample of a run ended (experiment/sample.h). May read the run's file.
    std::function<std::vector<EndpointRow>(const SettingRuns &setting, std::size_t run)> endpoints;
    /// The archive of a run; empty for a search without one. May read the run's file.
    std::function<std::vector<ArchiveEntry>(const SettingRuns &setting, std::size_t run)> archive;
};

/// The data as they are recorded below the folders of the runs.
RunData recorded_data(const Analysis &analysis, std::span<const SettingRuns> settings);

/// What a statistic asked of the runs.
struct Asked {
    std::vector<const SettingRuns *> settings; // each once, in the order asked for
    int generations = 0;                       // the most after which it wanted to know something
    bool missing = false; // some of this is not there, so that what it says does not count
};

/// A claim, to be judged by what the runs were after a number of generations.
struct ClaimCase {
    const RunData &data;
    const Claim &claim;
    int generations;
};

/// What a claim's function says: one row of claims.csv.
struct Finding {
    std::string effect_name;
    Maybe effect, low, high;   // low and high: of the bootstrap interval, none with too few runs
    Maybe p;                   // of a difference, or of a count
    std::string method;        // how p was computed: exact, normal or drawn
    Maybe p_equivalence;       // of no difference beyond a bound
    std::string verdict, note; // verdict: one of the verdicts()
};

/// reproduced, contradicted, inconclusive.
std::span<const std::string_view> verdicts();

/// A table of the experiment's own: a cell is empty, a finite number, or a text of one line.
struct OwnTable {
    using Cell = std::variant<std::monostate, double, std::string>;
    std::vector<std::string> columns;
    std::vector<std::vector<Cell>> rows; // as wide as `columns`
};

/// What the settings that were asked for lack of what was planned, in words; empty if nothing. `wanted` and `generations`
/// are the numbers of generations that were asked for and that there are.
std::string shortfall(std::span<const SettingRuns *const> settings, const Analysis &analysis, int wanted,
                      int generations);

/// A table's row as a line of CSV.
std::string line_of(const std::vector<OwnTable::Cell> &row);

} // namespace planula
