// SPDX-License-Identifier: MIT
// How sensitive results are to a number: individuals that evolved with the standard value of a parameter are simulated
// again with another. Their displacement and viability show whether a value that is not published (origin `ours`)
// decides the results. Evolution is not repeated, so this is the effect on bodies and gaits that suit the standard
// value, not on those that would have evolved with the other.
#pragma once

#include "analysis/analysis.h"
#include "experiment/spec.h"
#include "genome/genome.h"
#include "tables/columns.h"

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace planula {

/// Individuals of one setting and their lives with the standard values.
struct Sample {
    const Spec *spec = nullptr;
    int population = 0, generations = 0; // of the runs; of different lengths, the shortest
    std::vector<Genome> genomes;
    std::vector<Life> lives;
};

/// For each setting with chosen runs, up to `count` individuals drawn from the last generations of all
/// its complete runs, by chance that depends on the setting's name, the seeds and the slots alone. Throws
/// InputError for damaged runs and if there is no run at all.
std::vector<Sample> draw_samples(std::span<const Spec> settings, const RunChoice &runs, int count,
                                 int threads);

/// Whether a life in this setting can depend on the parameter: it is one of development, network, body, gait, or of the
/// setting's own world. A number that the experiment states itself counts as the parameter that the paper takes it
/// from.
bool concerns(const ParameterRow &parameter, const Spec &spec);

/// What lives in this setting use: the parameter's value, or the number that the experiment states instead of it.
double used(const ParameterRow &parameter, const Spec &spec);

/// The parameters of origin `ours` that concern a life anywhere: those that are varied unless others are
/// asked for.
std::vector<std::string_view> assumed_parameters();

/// `standard` times `factor`, brought into the parameter's range, or else no farther out than `standard` is, and
/// rounded if it must be whole.
double varied(const ParameterRow &parameter, double standard, double factor);

/// The sample's lives under `changed`, its setting with one parameter's value changed, against those before.
SensitivityRow vary(const Sample &sample, const Spec &changed, const ParameterRow &parameter, int threads);

} // namespace planula
