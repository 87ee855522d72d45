// SPDX-License-Identifier: MIT
// The states of a run that are kept on disk, sealed (storage/sealed.h) and packed. Each holds all that the run needs to
// resume with the same results: where it stands, and how long every table was.
//
// A run that is under way has `checkpoint`, and the one before it as `checkpoint.previous`. At every moment, whatever
// happens to the process or the machine, one of them is whole; the tables that it refers to were on disk before it. In
// `states/` stay those before generations 25, 50 and every multiple of 100, for audits, and that before the run's last
// generation, from which it can become longer. The former may be removed from a complete run to save space.
//
// A file that was cut or changed is recognised by its seal and passed over; one with a right seal and invalid content
// is refused.
#pragma once

#include "storage/journal.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planula {

struct KeptState {
    std::string identity;                                    // Identity::sha256() of the run
    int generation = 0;                                      // the next to be simulated
    std::vector<std::pair<std::string, JournalMark>> tables; // by the name of the table's file
    std::string link;                                        // of the chain, before this generation
    std::int64_t archive = 0;                                // entries of the search's archive
    double best_fitness = 0;                                 // of all generations before
    std::string state;                                       // the RunState, saved
    std::string memory;                                      // the judge's, as it gave it

    /// The mark of a table. Throws InputError if the table has no mark.
    const JournalMark &mark_of(std::string_view table) const;
};

/// Whether the state before this generation stays in states/ permanently, however long the run becomes.
constexpr bool is_kept_generation(int generation) {
    return generation == 25 || generation == 50 || (generation > 0 && generation % 100 == 0);
}

/// Whether a complete run of this many generations has the state before this one in states/.
constexpr bool is_kept_at_end(int generation, int generations) {
    return is_kept_generation(generation) || generation == generations - 1;
}

/// states/NNNNNN.state in a run's folder.
std::filesystem::path state_path(const std::filesystem::path &folder, int generation);

/// Nothing if the file is damaged. Throws InputError that names the file if it is whole and no kept state, or is not
/// there, and IoError if it cannot be read.
std::optional<KeptState> read_state(const std::filesystem::path &path);

/// The generations of which states/ has a file, ascending.
std::vector<int> kept_generations(const std::filesystem::path &folder);

/// Writes the state into states/; the SHA-256 of the file. Throws CreateError or IoError.
std::string keep_state(const std::filesystem::path &folder, const KeptState &state);

/// Removes from states/ what a process was writing when it was killed.
void remove_unfinished_states(const std::filesystem::path &folder);

/// Puts a new checkpoint beside the one before. Throws IoError or CreateError.
void write_checkpoint(const std::filesystem::path &folder, const KeptState &state);

/// The checkpoints of a folder that are there, the newest first.
std::vector<std::filesystem::path> checkpoints(const std::filesystem::path &folder);

/// Removes all checkpoints of the folder.
void remove_checkpoints(const std::filesystem::path &folder);

} // namespace planula
