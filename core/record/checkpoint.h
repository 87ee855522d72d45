// SPDX-License-Identifier: MIT
// What a run's directory remembers of a run that is not finished: `checkpoint`, and the one before it as
// `checkpoint.previous`. At every moment, whatever happens to the process or the machine, one of them is whole;
// the tables that it speaks of were on disk before it. A checkpoint that was cut or changed is known by its
// seal (record/sealed.h) and passed over; one that is whole and makes no sense is refused.
#pragma once

#include "record/journal.h"

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace planula {

struct Checkpoint {
    std::string identity;                                    // of the run: what decides its results
    int generation = 0;                                      // the next to be lived
    int generations = 0;                                     // of the whole run
    std::vector<std::pair<std::string, JournalMark>> tables; // by the name of the table's file
    std::string state;                                       // the RunState, saved
    std::string crown;                                       // what the record knows of the champion, saved
    std::string memory;                                      // the judge's, as it gave it

    /// The mark of a table. Throws InputError if there is none.
    const JournalMark &mark_of(std::string_view table) const;
};

struct FoundCheckpoint {
    std::optional<Checkpoint> checkpoint;       // the newest that is whole
    std::filesystem::path path;                 // where it lies
    std::vector<std::filesystem::path> damaged; // those passed over
};

/// Reads what lies in the folder. Throws InputError that names the file if a whole checkpoint is none.
FoundCheckpoint find_checkpoint(const std::filesystem::path &folder);

/// Puts a new checkpoint beside the one before. Throws IoError or CreateError.
void write_checkpoint(const std::filesystem::path &folder, const Checkpoint &checkpoint);

/// Removes all checkpoints of the folder.
void remove_checkpoints(const std::filesystem::path &folder);

} // namespace planula
