// SPDX-License-Identifier: MIT
// The rows of the reduced tables, each from the histories of one setting that has runs.
#pragma once

#include "analysis/analysis.h"
#include "analysis/survey.h"

#include <span>
#include <vector>

namespace planula {

SettingRow setting_row(const SettingRuns &setting);
std::vector<WorldRow> world_rows(const SettingRuns &setting);
std::vector<RunRow> run_rows(const SettingRuns &setting);
std::vector<CurveRow> curve_rows(const SettingRuns &setting, const Analysis &analysis);
std::vector<ShapeDiversityRow> shape_diversity_rows(const SettingRuns &setting, const Analysis &analysis);
/// Medians over the runs that have a value.
std::vector<HeredityRow> heredity_rows(const SettingRuns &setting);
EntropyRow entropy_row(const SettingRuns &setting, const Analysis &analysis);
std::vector<OutcomeRow> outcome_rows(const SettingRuns &setting);
std::vector<FitnessShareRow> fitness_share_rows(const SettingRuns &setting);

/// The best runs of a setting whose best individuals are shown, as in Figures 3 to 5.
inline constexpr std::size_t shown_runs = 3;

/// The best individuals of the shown runs, or of all if there are fewer. Throws InputError if a file is damaged.
std::vector<BestGenomeRow> best_genome_rows(const SettingRuns &setting);

/// A run that represents its setting: best or median.
struct Representative {
    const char *role;
    std::size_t run;
};
std::vector<Representative> representatives(const SettingRuns &setting);

std::vector<EndpointPathRow> endpoint_path_rows(const SettingRuns &setting, const Representative &chosen);

/// Each viable individual of the run is taken with probability `share`, drawn from its own stream (seed of
/// the run, generation, slot): whether it is taken depends on nothing else. Reads the run's individuals.
std::vector<EndpointRow> endpoint_rows(const SettingRuns &setting, const Representative &chosen,
                                       double share);

/// sample_share, or as much more as a run of this setting needs for sample_least individuals; at most 1.
double sampled_share(const SettingRuns &setting, const Analysis &analysis);

/// The archive of the best run; none for a search without one. Reads the run's archive.
std::vector<ArchivePointRow> archive_point_rows(const SettingRuns &setting);

} // namespace planula
