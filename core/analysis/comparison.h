// SPDX-License-Identifier: MIT
// What settings reached, beside each other: medians, differences, effect sizes and tests of two settings at a time,
// from their recorded runs after the same number of generations (decision 0029).
//
// Runs of the same seed are pairs if every seed of one setting is also one of the other: Wilcoxon's signed-rank test,
// and intervals of pairs. Else the runs are independent samples: his rank-sum test. p is corrected after Holm over all
// comparisons that are made together.
#pragma once

#include "analysis/analysis.h"
#include "analysis/measures.h"
#include "experiment/spec.h"
#include "tables/columns.h"

#include <span>
#include <string>
#include <vector>

namespace planula {

/// A setting that is compared, and where its runs are.
struct Contender {
    std::string name; // in tables and sentences
    const Spec *spec;
    RunChoice choice;
};

/// How settings are compared.
struct ComparisonPlan {
    std::vector<Measure> measures;
    int generations = 0;      // after which the runs are compared; 0: as many as all of them have
    std::string against;      // the contender that all others are compared with; empty: each pair of them
    bool by_seed = true;      // whether runs of the same seed may be pairs
    double confidence = 0.95; // of intervals; a p below 1 - confidence is significant
    int resamples = 10000;    // of a bootstrap interval
    int interval_runs = 10;   // fewer runs have no bootstrap interval
    double direction_distance = 1; // cells; who moved less has no direction and no side
};

struct Comparisons {
    int generations = 0;
    double confidence = 0;                    // of every interval
    std::vector<ComparedRunRow> runs;         // by measure, contender and seed
    std::vector<ComparedSettingRow> settings; // by measure and contender
    std::vector<ComparisonRow> rows;          // by measure, then by contender
};

/// Compares two contenders or more, of different names. Reads their runs and checks their files. Throws InputError for
/// contenders without runs, all together, and for damaged runs.
Comparisons compare(std::span<const Contender> contenders, const ComparisonPlan &plan);

} // namespace planula
