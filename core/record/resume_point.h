// SPDX-License-Identifier: MIT
// Where a run resumes that was stopped, or that is to become longer: at its newest kept state (record/kept_state.h)
// that can be read.
#pragma once

#include "experiment/run.h"
#include "record/kept_state.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

struct ResumePoint {
    std::optional<KeptState> kept; // nothing: the run starts at its beginning
    std::filesystem::path file;    // of the kept state
    // Whether the tables that the state knows of are journals or published; nothing without a state.
    JournalStart::From tables = JournalStart::From::nothing;
    std::vector<std::filesystem::path> damaged; // kept states that were passed over

    /// Where the journal of a table begins. Throws InputError that names the kept state if it does not know the table.
    JournalStart start_of(std::string_view table) const;
    /// The state of the run in this folder. `spec` has as many generations as the run will have. Throws InputError that
    /// names the kept state if it is not that of a run of this setting.
    RunState load(const std::filesystem::path &folder, const Spec &spec) const;
};

/// The resume point of the run with this identity (Identity::sha256()), `complete` generations of which are published.
/// A state within these belongs to the published tables, a later one to the journals. Throws InputError for a state of
/// another run, if there were states and none can be read, and if its journals are not there.
ResumePoint find_resume_point(const std::filesystem::path &folder, const std::string &identity, int complete);

/// Whether a process is making, or was making, a run longer that has this many complete generations: there is a
/// checkpoint or a kept state beyond their end, or a damaged checkpoint.
bool is_becoming_longer(const std::filesystem::path &folder, int complete);

} // namespace planula
