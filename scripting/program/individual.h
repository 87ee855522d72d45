// SPDX-License-Identifier: MIT
// The individual of a recorded run that a command is asked for: a champion, by its genome, or any, by its place.
#pragma once

#include "genome/genome.h"
#include "program/arguments.h"
#include "record/run_reader.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace planula {

inline constexpr Option champion_option{
    "genome", "ID|best", "a champion by the number of its genome (default: best, the last champion)"};
inline constexpr Option generation_option{
    "generation", "G", "with --slot: any individual of the run, by its generation, from 0"};
inline constexpr Option slot_option{"slot", "S", "the place of the individual in its generation, from 0"};

struct AskedIndividual {
    int generation = 0, slot = 0;
    Genome genome;
    double fitness = 0, displacement = 0;
    int cells = 0;
    std::string life_text; // its evaluation in words
};

/// The run whose folder is the operand, or the only one below it. Throws InputError.
RecordedRun asked_run(const Arguments &arguments);

/// The id that --genome asks for; nothing for the best. Throws UsageError.
std::optional<std::int64_t> asked_genome(const Arguments &arguments);

/// The champion with the genome of --genome, or the last one, as the run has recorded it; with --generation and --slot
/// the individual there, which is simulated again. Throws UsageError, InputError and Stopped.
AskedIndividual asked_individual(const Arguments &arguments, const RecordedRun &run);

/// "osc-aq-ns, seed 1, generation 5, genome 99".
std::string title_of(const AskedIndividual &individual, const RecordedRun &run);

/// Throws CreateError if the user named what is there and not a regular file, such as a device: it is not replaced.
void check_replaceable(const std::filesystem::path &path);
/// Writes a file that the user named, after that check.
void write_new_file(const std::filesystem::path &path, const std::string &text);

} // namespace planula
