// SPDX-License-Identifier: MIT
// The end of a run: every table gets its name, the manifest is written, and what only a run under way needs is removed,
// in an order in which a process may be killed at any moment.
#pragma once

#include "record/run_tables.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace planula {

/// A run that has all its generations.
struct CompleteRun {
    const std::filesystem::path &folder;
    const Spec &spec;
    std::uint64_t seed;
    int generations;
    const std::string &identity, &link; // Identity::sha256(), and the chain's last link
};

/// Publishes the tables, removes the states of a shorter run, writes the manifest, and removes the journals.
void complete_run(const CompleteRun &run, RunTables &tables);

/// Removes what a process that was killed at the very end of a run left beside its complete results, unless the run is
/// becoming longer. `complete`: its generations, at least 1.
void remove_leftovers(const std::filesystem::path &folder, int complete);

/// The same, of a folder that this process does not hold. Does nothing if the run is not complete or is in use.
void tidy_complete_run(const std::filesystem::path &folder);

} // namespace planula
