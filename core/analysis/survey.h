// SPDX-License-Identifier: MIT
// The runs that there are of each setting of an experiment, and which of them represent it.
#pragma once

#include "analysis/analysis.h"
#include "analysis/history.h"
#include "experiment/spec.h"

#include <filesystem>
#include <span>
#include <vector>

namespace planula {

/// The runs of one setting; may be empty.
struct SettingRuns {
    const Spec *spec = nullptr;
    std::vector<RecordedRun> runs;     // by ascending seed
    int generations = 0;               // that the setting asks for, and all runs have; 0 without runs
    std::vector<RunHistory> histories; // of these runs, once they are read

    /// The histories' facts at the end.
    const RunFacts &outcome_of(std::size_t run) const { return histories[run].after.at(generations); }
};

/// Finds the chosen runs of a setting, with as many generations as it asks for; there may be none.
SettingRuns runs_of_setting(const Spec &spec, const RunChoice &choice);

/// Finds the chosen runs of every setting. Throws InputError if no setting has a run.
std::vector<SettingRuns> survey(std::span<const Spec> settings, const RunChoice &choice);

/// Places of the runs in descending order of their champions' fitness; of equals the lower seed comes first.
std::vector<std::size_t> ranking(const SettingRuns &setting);

/// The rank, from 0, of the best run below the median of `count` runs: the 11th of 20, the 3rd of 3; of a
/// single run, that run.
std::size_t rank_below_median(std::size_t count);

} // namespace planula
