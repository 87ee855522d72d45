// SPDX-License-Identifier: MIT
// From the directories of runs to what the paper shows: tidy tables, the claims with their verdicts, and
// frames of individuals simulated again (decision 0015). An experiment states which samples it wants, its claims with
// the functions that judge them, and tables of its own (decision 0023); the arithmetic is in core/statistics. Where data
// are missing the tables say so: a setting without runs has no rows, and a claim whose data are not all there is open.
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

struct RunData;
struct ClaimCase;
struct Finding;
struct OwnTable;
struct Asked;

/// A claim, and the function that judges it (analysis/statistic.h).
struct Claim {
    std::string id, statement, section, paper; // the last two: where it is made, and on which evidence
    std::string test;                          // how it is judged, in a word for the table
    std::string a, b;                          // the settings that it compares; b may be empty
    int generation = 0;      // counted from 1: 2000 is the last of 2000; 0: the last of the design
    bool calibrated = false; // what it says was used to choose the model, so that its verdict is no evidence
    std::function<Finding(const ClaimCase &, Asked &)> judge;
};

/// A table that an experiment makes beside those of reduce(): <name>.csv.
struct TableStatement {
    std::string name;
    std::function<OwnTable(const RunData &, Asked &)> make;
};

/// What an experiment wants to know of its runs.
struct Analysis {
    std::string experiment;
    std::vector<Claim> claims;
    std::vector<TableStatement> tables;
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
/// tables into `out`, the manifest last. A table of the experiment whose data are not all there is not written, which is
/// told. Throws InputError for damaged runs and without any run, and CreateError
/// if another process writes into `out` or that is the folder of a run.
void reduce(const Analysis &analysis, std::span<const Spec> settings, const RunChoice &runs,
            const std::filesystem::path &out);

/// Simulates the best individuals of each setting again, from best_genomes.csv in `data`, and writes the frame
/// tables into `out`. Throws InputError if a life differs from the record: the data are not of this experiment
/// or version.
void write_frames(std::span<const Spec> settings, const std::filesystem::path &data,
                  const std::filesystem::path &out);

} // namespace planula
