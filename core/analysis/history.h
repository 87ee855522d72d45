// SPDX-License-Identifier: MIT
// What the analysis knows of one run, gathered while its tables are read once, row by row: memory does not
// grow with the number of individuals.
#pragma once

#include "base/text.h"
#include "base/vec2.h"
#include "record/csv.h"
#include "record/run_reader.h"

#include <cstdint>
#include <map>
#include <span>
#include <vector>

namespace planula {

/// What a run had come to after a number of generations.
struct RunFacts {
    ChampionRow champion;           // the best individual so far
    double size_entropy = 0;        // Eq. 8: cell counts of all individuals with fitness above 0, nats
    std::int64_t viable = 0;        // those individuals
    double valid_share = 0;         // of the last of these generations
    double fitness_spread = 0;      // interquartile range over the champion's fitness, valid, last generation
    double direction_resultant = 0; // mean resultant length of the end directions of all that moved
    int side_switches = 0;          // of the best of each generation
};

struct RunHistory {
    std::int64_t seed = 0;
    ChampionRow crowned;                 // the champion of the whole run, whose genome best_genome.csv holds
    std::vector<double> best;            // fitness of each generation's best
    std::vector<Vec2d> best_moved;       // and its displacement from rest to end
    std::vector<double> shape_diversity; // of each generation
    GenerationRow first, last;
    std::map<int, RunFacts> after;      // by number of generations
    std::vector<double> fitness_shares; // of the last generation, by classes of fitness over the champion's
};

/// The champions of the run, each with a later generation than the one before; the first is of generation 0.
/// Throws InputError with file and line if they are not that.
std::vector<ChampionRow> read_champions(const RecordedRun &run);

/// Reads a run up to the last of the marks, which ascend from at least 1 to at most the run's generations.
/// `after` has an entry for each mark. Throws InputError with file and line if the tables are not those of a
/// run.
RunHistory read_history(const RecordedRun &run, std::span<const int> marks, int fitness_classes);

/// Calls visit(row) for each individual of the first generations, in order. Throws InputError with file and
/// line if they are not all there.

template <class Visit> void each_individual(const RecordedRun &run, int generations, Visit &&visit) {
    TableReader<IndividualRow> reader(run.folder);
    IndividualRow row;
    for (int generation = 0; generation < generations; ++generation)
        for (int slot = 0; slot < run.population; ++slot) {
            if (!reader.next(row)) reader.refuse("individuals are missing at the end");
            if (row.generation != generation || row.slot != slot)
                reader.refuse("generation " + to_text(row.generation) + ", slot " + to_text(row.slot) +
                              " where generation " + to_text(generation) + ", slot " + to_text(slot) +
                              " must follow");
            visit(row);
        }
}

} // namespace planula
