// SPDX-License-Identifier: MIT
// The statistics of an experiment, from its table: confidence, resamples, interval_runs, significance,
// sample_share, sample_least, fitness_classes, direction_distance, endpoints (settings whose end points are kept;
// all, if absent) and claims, each {id, statement, section, paper, test, a, b, generation, expect, level, count,
// bound}. What these mean: analysis/analysis.h.
#pragma once

#include "analysis/analysis.h"
#include "statement/reader.h"

#include <span>
#include <string>

namespace planula {

/// `settings` are those that claims and endpoints may mention; `experiment` and `design` as in Analysis.
Analysis read_statistics(const Value &table, const Place &place, const std::string &experiment,
                         const Parameters &design, std::span<const Spec> settings, Problems &problems);

} // namespace planula
