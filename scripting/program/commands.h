// SPDX-License-Identifier: MIT
// The commands of planula, and the parts that several of them share.
#pragma once

#include "program/arguments.h"
#include "statement/schema.h"

#include <cstdint>
#include <string>
#include <vector>

namespace planula {

const Command &run_command();
const Command &check_command();
const Command &describe_command();
const Command &reduce_command();
const Command &compare_command();
const Command &report_command();
const Command &frames_command();
const Command &witness_command();
const Command &sensitivity_command();
const Command &status_command();
const Command &lineage_command();
const Command &genome_command();
const Command &replay_command();
const Command &verify_command();
const Command &merge_command();
const Command &signature_command();
const Command &pace_command();
const Command &parameters_command();
const Command &columns_command();
const Command &reference_command();
const Command &completion_command();

/// All commands, in the order of --help.
std::vector<const Command *> all_commands();

/// Runs the command that the words after the program's name ask for. Returns the exit code (base/error.h); errors are
/// printed to console.err.
int run_program(const std::vector<std::string> &words, Console &console);

// ---- Options that several commands have -------------------------------------------------------------------

inline constexpr Option generations_option{"generations", "N",
                                           "generations of every run (default: as the script states)"};
inline constexpr Option population_option{"population", "N",
                                          "individuals of every generation (default: as the script states)"};
inline constexpr Option set_option{
    "set", "NAME=VALUE", "set a parameter in every setting; may be repeated; planula parameters lists them",
    true};
inline constexpr Option threads_option{"threads", "N",
                                       "number of threads (default: one for each processor, or some hundreds "
                                       "that wait for a graphics processor); "
                                       "no result depends on it"};
inline constexpr Option lanes_option{
    "lanes", "scalar|sse2|avx2|avx512",
    "instructions to compute with (default: the widest that this processor has); no result depends on it"};

inline constexpr Option chosen_seeds_option{
    "seeds", "A:B|N", "use only the runs of these seeds, and report each that is missing"};

/// What --set, --generations and --population ask for. Throws UsageError with rule, value and nearest name.
Overrides overrides_of(const Arguments &arguments);
/// Loads the experiment file that is the operand; `changes` come after those of the command line. Throws UsageError if
/// one of the command line changes nothing in any setting.
Experiment experiment_of(const Arguments &arguments, const Console &console, const Overrides &changes = {});
/// --seeds A:B or N; without it 1 … the parameter `seeds`. Throws UsageError.
std::vector<std::uint64_t> seeds_of(const Arguments &arguments, const Experiment &experiment);
/// One run that a command is asked for.
struct PlannedRun {
    std::size_t setting; // its index in the experiment
    std::uint64_t seed;
};
/// The runs that --seeds, --only and --part ask for: seed by seed, so that a command that is stopped has run all
/// settings equally far. Throws UsageError.
std::vector<PlannedRun> runs_of(const Arguments &arguments, const Experiment &experiment);
/// --levels, ascending; nothing without the option. Throws UsageError.
std::vector<int> levels_of(const Arguments &arguments);
/// The experiment that planula run is asked for. With levels, the script is checked with the last of them as its
/// generations.
Experiment experiment_to_run(const Arguments &arguments, const Console &console);
/// The runs that --runs and --seeds choose; those left out are reported to console.err.
RunChoice choice_of(const Arguments &arguments, const Experiment &experiment, Console &console);
/// --threads, or one for each processor; with a device, as many as keep it busy.
int threads_of(const Arguments &arguments);
/// Uses --lanes from now on, if it is given. Throws UsageError with the nearest name.
void use_lanes_of(const Arguments &arguments);
/// The folder of the experiment's runs that an option states, or build/runs/<experiment>.
std::string runs_folder(const Arguments &arguments, std::string_view option, const Experiment &experiment);

} // namespace planula
