// SPDX-License-Identifier: MIT
// The statistics of an experiment, from its table: confidence, resamples, interval_runs, significance,
// sample_share, sample_least, fitness_classes, direction_distance, endpoints (settings whose end points are kept;
// all, if absent), claims, each {id, statement, section, paper, test, a, b, generation, calibrated, judge}, and tables,
// {name = function}. What these mean: analysis/analysis.h, and of the functions statement/statistic_state.h.
#pragma once

#include "analysis/analysis.h"
#include "statement/reader.h"
#include "statement/statistic_state.h"

#include <span>
#include <string>

namespace planula {

/// `source` is where the table is stated; `settings` are those that claims and endpoints may mention; `experiment` and
/// `design` as in Analysis.
Analysis read_statistics(const Value &table, const Place &place, const StatisticSource &source,
                         const std::string &experiment, const Parameters &design,
                         std::span<const Spec> settings, Problems &problems);

} // namespace planula
