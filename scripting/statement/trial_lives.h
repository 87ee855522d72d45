// SPDX-License-Identifier: MIT
// Lives of evolved specimens (statement/specimens.h) under the conditions of a setting, and what its functions make of
// them: what examples cannot show. Nothing here changes a run.
#pragma once

#include "experiment/lives.h"
#include "statement/findings.h"
#include "statement/schema.h"
#include "tables/genome_table.h"

#include <span>
#include <string>
#include <vector>

namespace planula {

/// The lives of a setting's specimens.
struct TrialLives {
    std::vector<Life> complete;
    std::vector<Life> grown; // development alone, if the setting has a start
};

/// What the lives of a setting depend on, as a text: settings of equal texts have equal trial lives.
std::string conditions_text(const Spec &spec);

/// Simulates them. Throws Stopped.
std::vector<Life> complete_lives(const Spec &spec, std::span<const Genome> genomes, const Workers &workers,
                                 const StopRequest &stop);
std::vector<Life> grown_lives(const Spec &spec, std::span<const Genome> genomes, const Workers &workers,
                              const StopRequest &stop);

/// Calls the functions of setting `index` with the lives, and reports: a function that fails or returns what it must
/// not, a penalty of 0 for all, a result that is the same for all, and a world in which no specimen ends viable, moves,
/// or stays above the ground.
void judge_trials(const Experiment &experiment, std::size_t index, const TrialLives &lives,
                  Findings &findings);

/// Reports each number of the environment that the script states although no trial life changes without it.
void find_idle_numbers(const Experiment &experiment, std::size_t index, std::span<const Genome> genomes,
                       const TrialLives &lives, const StopRequest &stop, Findings &findings);

} // namespace planula
