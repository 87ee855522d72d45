// SPDX-License-Identifier: MIT
// From the directories of runs to what the paper shows: tidy tables, the claims with their verdicts, and
// frames of individuals simulated again (decision 0015). An experiment states which claims and samples it wants;
// the arithmetic is here and in core/statistics. Where data are missing the tables say so: a setting without
// runs has no rows, and a claim whose data are not all there is open.
//
// Words: the champion of a run is its best individual so far. Runs of a setting are compared over the
// generations that all of them have.
#pragma once

#include "experiment/spec.h"
#include "parameters/parameters.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace planula {

/// A claim of the paper: that the test comes out as expected for setting a (against setting b).
struct Claim {
    std::string id, statement, section, paper, test, a, b;
    int generation = 0;      // counted from 1: 2000 is the last of 2000; 0: the last of the design
    std::string expect;      // of the rank-sum tests: greater, less or no_difference
    double level = 0;        // of mean_ahead and cyclic
    int count = 0;           // of top_runs, cyclic and elongated
    double bound = 0;        // of no_difference and cyclic: the largest value that still counts as none
    bool calibrated = false; // what it says was used to choose the model, so that its verdict is no evidence
};

/// What an experiment wants to know of its runs.
struct Analysis {
    std::string experiment;
    std::vector<Claim> claims;
    std::vector<std::string> endpoint_settings; // settings whose explored end points are tabled
    double sample_share = 0;                    // of the individuals that enter the table of end points
    int sample_least = 0;                       // of a smaller run a larger share, this many on average
    double confidence = 0;                      // of all bootstrap intervals
    int resamples = 0;                          // of an interval, and draws of a permutation test
    int interval_runs = 10;                     // of fewer runs there is no interval
    double significance = 0;                    // p-values below this decide
    int fitness_classes = 20;                   // between nothing and a generation's highest; divides 100
    double direction_distance = 1;              // cells; who moved less has no direction and no side
    Parameters design; // as planned: seeds, generations and population of the whole experiment
};

/// The names valid in Claim::test. Every p is two-sided unless said otherwise, and every verdict needs one below the
/// significance: where so few runs cannot give that, the claim is inconclusive and its note says so. Runs are taken as
/// independent; that runs of one seed share generation 0 makes p too large rather than too small (decision 0015).
///
/// Rank-sum tests of a against b (effect: A12 with bootstrap interval; exact p below 50 runs, with ties as without):
///   best_at_generation  best fitness in that generation
///   size_entropy        Eq. 8 over the history up to that generation
///   fitness_spread      interquartile range of fitness in that generation, over its highest fitness
///   direction           mean resultant length of the end directions up to that generation
///   side_switches       how often the generation's best changed sides up to that generation
/// Expecting greater or less, p below the significance and A12 beyond 1/2 on that side reproduces, on the other side
/// contradicts. Expecting no_difference, the test of equivalence reproduces: A12 within 1/2 ± `bound`, which p of a
/// difference that is not significant does not show; without equivalence, a significant difference contradicts.
///
/// Permutation test of a against b:
///   mean_ahead  share of generations in which the mean best of a is at least that of b, with bootstrap interval; p: of
///               the difference of the means over all generations. With p below the significance, a ahead by that mean
///               and a share of at least `level` reproduce, b ahead contradicts
///
/// Counts, with exact p:
///   top_runs    how many of the best `count` runs of both are a's; with p below the significance all of them
///               reproduce, fewer than half contradict; p: hypergeometric
///   elongated   how many of the best `count` runs of both are a's and have a champion more elongated than the median
///               of all runs; judged as top_runs
///   cyclic      runs of a whose champion made less than `level` of its way, or of its muscles' changes, in the last
///               quarter. At most `count` reproduce if they show that the share of such runs is below `bound`
///               (one-sided binomial test, the p of equivalence); more contradict if they are too many beside the
///               original's `count` of design.seeds runs (p: Fisher's exact test, one-sided)
std::span<const std::string_view> claim_tests();

/// Throws InputError with the rule, the value and the nearest name for whatever is wrong in an analysis.
void check_analysis(const Analysis &analysis, std::span<const Spec> settings);

/// The runs that an analysis reads: of each setting those below <folder>/<setting> that have its identity, at least its
/// generations, and one of these seeds.
struct RunChoice {
    std::filesystem::path folder;
    std::vector<std::uint64_t> seeds; // empty: all that are there
    /// Told, a line each, which folder is left out and why, and which run of the seeds is missing.
    std::function<void(const std::string &line)> tell = [](const std::string &) {};
};

/// Reads the chosen runs as they were after the settings' generations, after checking their hashes, and writes the
/// tables into `out`, the manifest last. Throws InputError for damaged runs and without any run, and CreateError
/// if another process writes into `out` or that is the folder of a run.
void reduce(const Analysis &analysis, std::span<const Spec> settings, const RunChoice &runs,
            const std::filesystem::path &out);

/// Simulates the best individuals of each setting again, from best_genomes.csv in `data`, and writes the frame
/// tables into `out`. Throws InputError if a life differs from the record: the data are not of this experiment
/// or version.
void write_frames(std::span<const Spec> settings, const std::filesystem::path &data,
                  const std::filesystem::path &out);

} // namespace planula
