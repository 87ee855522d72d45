// SPDX-License-Identifier: MIT
// What the analysis knows of one run, gathered while its tables are read once, row by row: memory does not
// grow with the number of individuals. Everything comes from tables that are the same whether a run is recorded in full
// or as a sample, or of the individuals that both record.
#pragma once

#include "base/text.h"
#include "record/run_reader.h"
#include "tables/csv.h"

#include <cstdint>
#include <map>
#include <vector>

namespace planula {

/// What a run had come to after a number of generations.
struct RunFacts {
    ChampionRow champion;          // the best individual so far
    double size_entropy = 0;       // Eq. 8: cell counts of all individuals with fitness above 0, nats
    std::int64_t with_fitness = 0; // those individuals
    double valid_share = 0;        // of the last of these generations
    Maybe
        fitness_spread; // interquartile range over the highest fitness, valid, last generation; none if that is 0
    Maybe
        direction_resultant; // mean resultant length of the end directions of those that moved; none without any
    int side_switches = 0; // of the best so far that moved to a side
};

/// A run as it was after some generations, which may be fewer than it has.
struct RunHistory {
    std::int64_t seed = 0;
    std::vector<GenerationRow> generations; // by their number
    std::map<int, RunFacts> after;          // by number of generations: 1 … all of them
    // Of each generation, by classes of fitness over its highest: shares of the population.
    std::vector<std::vector<double>> fitness_shares;
};

/// The champions of the run, each with a later generation than the one before; the first is of generation 0.
/// Throws InputError with file and line if they are not that.
std::vector<ChampionRow> read_champions(const RecordedRun &run);

/// The champion after a number of generations.
const ChampionRow &champion_after(const std::vector<ChampionRow> &champions, int generations);

/// Reads the first generations of a run, at least 1 and at most all that it has. `fitness_classes` divides 100. Who ends
/// nearer than `direction_distance`, in cells, to where it rested has no direction. Directions after g generations are
/// those of the individuals in the sample of a run that ends there (experiment/sample.h), however the run is recorded.
/// Throws InputError with file and line if the tables are not those of a run.
RunHistory read_history(const RecordedRun &run, int generations, int fitness_classes,
                        double direction_distance);

/// Calls visit(row) for each recorded individual of the first generations, in order. Throws InputError with file and
/// line if they are not in order, or not all there in a run that is recorded in full.
template <class Visit> void each_individual(const RecordedRun &run, int generations, Visit &&visit) {
    TableReader<IndividualRow> reader(run.folder);
    int generation = 0, slot = -1;
    for (IndividualRow row; reader.next(row) && row.generation < generations; visit(row)) {
        const bool is_new = row.generation > generation;
        const bool follows = row.slot < run.population && (is_new ? row.slot >= 0 : row.slot > slot);
        const bool is_next =
            is_new ? slot + 1 == run.population && row.generation == generation + 1 && row.slot == 0
                   : row.slot == slot + 1;
        if (row.generation < generation || !follows || (run.record.full && !is_next))
            reader.refuse("generation " + to_text(row.generation) + ", slot " + to_text(row.slot) +
                          " does not follow generation " + to_text(generation) + ", slot " + to_text(slot));
        generation = row.generation, slot = row.slot;
    }
    if (run.record.full && (generation + 1 != generations || slot + 1 != run.population))
        reader.refuse("individuals are missing at the end");
}

} // namespace planula
