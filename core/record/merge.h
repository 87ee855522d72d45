// SPDX-License-Identifier: MIT
// Gathering the parts of a campaign. A run that is nowhere yet is copied; of two lengths of one run the longer stays,
// if the chain of the shorter is its beginning; anything else is refused by name. A run appears in its place
// whole or not at all: a process that is killed leaves what was there before, and the same call continues.
#pragma once

#include <filesystem>
#include <string>

namespace planula {

/// What happened to a run that was to be gathered. Unfinished: it is longer than the one that is there, but has fewer
/// generations complete, so that the other stays until it has ended.
enum class Merged { copied, longer, known, unfinished };

/// Brings the run of one folder, complete or under way, into another, which need not exist. Throws RefusedError if
/// either is in use or holds something else, InputError if the files of a run do not agree or the two contradict each
/// other, and IoError.
Merged merge_run(const std::filesystem::path &from, const std::filesystem::path &into);

/// Ends what a process that was killed while it merged left beside the runs of a setting's folder.
void end_merges(const std::filesystem::path &setting);

} // namespace planula
