// SPDX-License-Identifier: MIT
// The chain of a run: one link for each generation, a hash over the link before, over all that the generation is
// (experiment/digest.h), and over the rows that it adds to each table. The first link is made of the run's identity,
// its seed included. So the last link identifies the whole run, and a changed digit in a table breaks the chain at that
// generation. Only simulating again can show that a whole chain was forged.
#pragma once

#include "experiment/identity.h"
#include "record/run_tables.h"

#include <filesystem>
#include <string>
#include <vector>

namespace planula {

/// What stands before the link of generation 0.
std::string chain_start(const std::string &identity_sha256);

/// The hash over all that a generation is, without its rows.
std::string generation_sha256(const Generation &generation);

/// The row of a generation, its link following the one before.
ChainRow chain_row(const std::string &before, const Generation &generation, const RowTexts &rows);

/// Reads chain.csv of a folder. Throws InputError with file and line if the rows are not those of generations 0 to the
/// last.
std::vector<ChainRow> read_chain(const std::filesystem::path &folder);

/// Reads the tables of a folder and compares them with its chain. Throws InputError that
/// names the first generation which differs.
void check_chain(const std::filesystem::path &folder, const std::string &identity_sha256,
                 const std::vector<ChainRow> &chain);

} // namespace planula
