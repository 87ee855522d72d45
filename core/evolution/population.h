// SPDX-License-Identifier: MIT
// A population in species, and the first one of a run (§2.7; decision 0013). evolution/reproduce.h makes the next one
// from it.
//
// Slot order is the order of everything: species in list order, members as placed. genomes[i] is slot i.
#pragma once

#include "genome/genome.h"
#include "genome/innovations.h"
#include "parameters/parameters.h"

#include <cstdint>
#include <vector>

namespace planula {

struct Species {
    int id = 0;
    Genome representative;    // the first placed of this generation; children are compared with it
    int age = 0;              // generations
    int stagnation = 0;       // generations since best_ever rose
    double best_ever = 0;     // highest score, at least fitness_floor once the species has bred
    bool best = false;        // holds the mark of the best species, which never counts as stagnating
    std::vector<int> members; // slots, as placed
};

struct Population {
    int generation = 0;
    std::vector<Genome> genomes; // slot order
    std::vector<Species> species;
    double threshold = 0; // the compatibility threshold that placed this generation
    double best_ever = 0; // best score of all generations before this one
    std::int64_t next_genome = 0;
    int next_species = 0;
    Innovations innovations; // the run's record
};

/// The shape of the networks that a population evolves.
struct NetworkShape {
    int inputs = 0, outputs = 0; // inputs include the bias
    bool recurrent = false;
};

/// Generation 0: every input linked to every output, no hidden node, weights by u± (§2.7.2), placed in species one
/// after the other.
Population initial_population(const NetworkShape &shape, const NeatParameters &parameters,
                              std::uint64_t seed);

} // namespace planula
