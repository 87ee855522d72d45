// SPDX-License-Identifier: MIT
#include "tables/run_rows.h"

#include "evaluation/cyclic_gait.h"
#include "statistics/summary.h"
#include "tables/heredity.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace planula {

namespace {

constexpr int fitness_classes = 100;
constexpr double near_best = 0.9; // of the highest fitness

const char *to_column(Outcome outcome) { return name_of(outcome); }
double to_column(double value) { return value; }
int to_column(int value) { return value; }

/// Fills every column of a row that is called as a field of the life; the columns of a point end in _x and _y.
template <class AnyLife, class Row> void fill(const AnyLife &life, Row &row) {
#define FIELD(type, name, initial, unit, known, meaning)                                                     \
    if constexpr (requires { row.name; }) row.name = to_column(life.name);                                   \
    if constexpr (requires { row.name##_x, row.name##_y; })                                                  \
        row.name##_x = life.name.x, row.name##_y = life.name.y;
#include "evaluation/life.inl"
}

/// Adds one life to the counts of its generation.
void count(const Life &life, int birth_limit, GenerationRow &row) {
    switch (life.outcome) {
    case Outcome::viable:
        ++row.viable;
        break;
    case Outcome::died_out:
        ++row.died_out;
        break;
    case Outcome::too_small:
        ++row.too_small;
        break;
    case Outcome::overgrown:
        ++row.overgrown;
        break;
    case Outcome::never_settled:
        ++row.never_settled;
        break;
    case Outcome::exploded:
        ++row.exploded;
        break;
    }
    row.overborn += life.births >= birth_limit;
}

/// Mean and quartiles of the fitness.
void add_fitness(const Generation &g, GenerationRow &row) {
    std::vector<double> valid;
    for (const Evaluation &evaluation : g.evaluations) {
        row.mean_fitness += evaluation.fitness;
        if (evaluation.valid()) valid.push_back(evaluation.fitness);
    }
    row.valid = static_cast<int>(valid.size());
    if (valid.empty()) return;
    row.fitness_low = quantile(valid, 0.25);
    row.fitness_median = quantile(valid, 0.5);
    row.fitness_high = quantile(valid, 0.75);
}

/// How many are nearly as fit as the best.
void add_near_best(const Generation &g, GenerationRow &row) {
    const double bound = near_best * row.best_fitness;
    for (const Evaluation &evaluation : g.evaluations) row.near_best += evaluation.fitness > bound;
    row.near_best /= static_cast<double>(g.evaluations.size());
}

/// How many of those with fitness move to the end.
void add_cyclic(const Generation &g, const Parameters &parameters, GenerationRow &row) {
    int cyclic = 0, all = 0;
    for (std::size_t slot = 0; slot < g.lives.size(); ++slot) {
        if (g.evaluations[slot].fitness <= 0) continue;
        const Life &life = g.lives[slot];
        cyclic += is_cyclic(late_share(life, parameters.gait), life.late_actuation);
        ++all;
    }
    if (all > 0) row.cyclic = static_cast<double>(cyclic) / all;
}

/// Where the individuals went.
void add_headings(const Generation &g, GenerationRow &row) {
    for (const Life &life : g.lives) {
        const double distance = life.displacement();
        if (distance == 0) continue;
        const Vec2d heading = (life.finish - life.rest) / distance;
        ++row.moved;
        row.heading_x += heading.x;
        row.heading_y += heading.y;
    }
}

} // namespace

GenerationRow generation_row(const Generation &g, const Parameters &parameters) {
    GenerationRow row;
    row.generation = g.number;
    row.best_slot = g.best;
    row.best_fitness = g.evaluations[g.best].fitness;
    row.species = static_cast<int>(g.population.species.size());
    row.threshold = g.population.threshold;
    row.archive = static_cast<int>(g.search.archive().size());
    row.archive_threshold = g.search.archive_threshold();

    const Vec2d best = g.lives[g.best].finish - g.lives[g.best].rest;
    row.best_x = best.x, row.best_y = best.y;
    add_fitness(g, row);
    add_headings(g, row);
    add_near_best(g, row);
    add_cyclic(g, parameters, row);
    add_heredity(g, row);

    // Means are sums in slot order over the population's size.
    for (const Genome &genome : g.population.genomes) {
        row.mean_links += static_cast<double>(genome.links.size());
        row.mean_hidden += genome.hidden();
    }
    for (double *mean : {&row.mean_fitness, &row.mean_links, &row.mean_hidden})
        *mean /= static_cast<double>(g.lives.size());
    std::vector<ShapeDistribution> shapes;
    for (const Life &life : g.lives) {
        count(life, parameters.development.birth_limit, row);
        if (life.outcome == Outcome::viable) shapes.push_back(life.shape);
    }
    row.shape_diversity = shape_diversity(shapes);
    return row;
}

std::vector<SizeRow> size_rows(const Generation &g) {
    std::map<int, int> sizes;
    for (std::size_t slot = 0; slot < g.lives.size(); ++slot)
        if (g.evaluations[slot].fitness > 0) ++sizes[g.lives[slot].cells];
    std::vector<SizeRow> rows;
    for (const auto &[cells, individuals] : sizes) rows.push_back({g.number, cells, individuals});
    return rows;
}

std::vector<FitnessClassRow> fitness_class_rows(const Generation &g) {
    const double best = g.evaluations[g.best].fitness;
    std::map<int, int> classes;
    for (const Evaluation &evaluation : g.evaluations) {
        // In this order 29 of 100 are 29 %.
        const double percent = best > 0 ? std::floor(evaluation.fitness * fitness_classes / best) : 0;
        ++classes[static_cast<int>(std::min(percent, fitness_classes - 1.0))];
    }
    std::vector<FitnessClassRow> rows;
    for (const auto &[percent, individuals] : classes) rows.push_back({g.number, percent, individuals});
    return rows;
}

std::vector<int> species_of_slots(const Population &population) {
    std::vector<int> species(population.genomes.size(), -1);
    for (const Species &group : population.species)
        for (const int slot : group.members) species.at(slot) = group.id;
    return species;
}

ChampionRow champion_row(const Generation &g, const Parameters &parameters) {
    const Life &life = g.lives[g.best];
    const Genome &genome = g.population.genomes[g.best];
    const Vec2d moved = life.finish - life.rest;
    ChampionRow row{.generation = g.number,
                    .slot = g.best,
                    .genome = genome.id,
                    .fitness = g.evaluations[g.best].fitness,
                    .displacement = life.displacement(),
                    .late_share = late_share(life, parameters.gait),
                    .x = moved.x,
                    .y = moved.y,
                    .links = static_cast<int>(genome.links.size()),
                    .hidden = genome.hidden()};
    fill(life, row);
    return row;
}

IndividualRow individual_row(const Generation &g, int slot, int species) {
    const Life &life = g.lives[slot];
    const Genome &genome = g.population.genomes[slot];
    const Evaluation &evaluation = g.evaluations[slot];
    IndividualRow row{.generation = g.number,
                      .slot = slot,
                      .genome = genome.id,
                      .mother = genome.mother,
                      .father = genome.father,
                      .origin = name_of(genome.origin),
                      .species = species,
                      .fitness = evaluation.fitness,
                      .score = g.scores[slot],
                      .penalty = evaluation.penalty,
                      .links = static_cast<int>(genome.links.size()),
                      .hidden = genome.hidden()};
    fill(life, row);
    return row;
}

SpeciesRow species_row(const Generation &g, const Species &species) {
    SpeciesRow row{.generation = g.number,
                   .species = species.id,
                   .size = static_cast<int>(species.members.size()),
                   .age = species.age,
                   .stagnation = species.stagnation,
                   .was_best = species.best ? 1 : 0,
                   .best_ever = species.best_ever,
                   .representative = species.representative.id};
    for (const int slot : species.members) {
        row.best_score = std::max(row.best_score, g.scores[slot]);
        row.mean_score += g.scores[slot];
    }
    row.mean_score /= static_cast<double>(row.size);
    return row;
}

} // namespace planula
