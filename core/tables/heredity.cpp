// SPDX-License-Identifier: MIT
#include "tables/heredity.h"

#include "statistics/rank_correlation.h"
#include "statistics/summary.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace planula {

namespace {

constexpr double near_mother = 0.1; // of the mother's fitness

/// One value of every mother and of her child.
struct Pairs {
    std::vector<double> mother, child;

    void add(double of_mother, double of_child) {
        mother.push_back(of_mother);
        child.push_back(of_child);
    }
    bool are_enough() const { return mother.size() >= static_cast<std::size_t>(least_pairs); }
    Maybe correlation() const { return are_enough() ? rank_correlation(mother, child) : std::nullopt; }
    /// Of measure(mother, child) over the pairs.
    template <class Measure> Maybe median_of(Measure &&measure) const {
        if (!are_enough()) return std::nullopt;
        std::vector<double> values;
        for (std::size_t i = 0; i < mother.size(); ++i) values.push_back(measure(mother[i], child[i]));
        return median(values);
    }
};

/// Finite, however small the mother's fitness is.
double ratio(double mother, double child) {
    return std::min(child / mother, std::numeric_limits<double>::max());
}

/// Scripts may give fitness to a body without cells.
double relative_change(double mother, double child) {
    return std::abs(child - mother) / std::max(mother, 1.0);
}

} // namespace

void add_heredity(const Generation &g, GenerationRow &row) {
    Pairs all, fitness, cells; // of all children; of those with fitness
    int near = 0;
    for (std::size_t slot = 0; slot < g.lives.size(); ++slot) {
        const MotherLife *mother = g.mothers.of(g.population.genomes[slot]);
        if (!mother || mother->fitness <= 0) continue;
        const double own = g.evaluations[slot].fitness;
        all.add(mother->fitness, own);
        near += std::abs(own - mother->fitness) <= near_mother * mother->fitness;
        if (own <= 0) continue;
        fitness.add(mother->fitness, own);
        cells.add(mother->cells, g.lives[slot].cells);
    }
    row.children = static_cast<int>(all.mother.size());
    row.pairs = static_cast<int>(fitness.mother.size());
    row.heredity_fitness = fitness.correlation();
    row.heredity_cells = cells.correlation();
    row.kept_fitness = all.median_of(ratio);
    if (all.are_enough()) row.near_mother = static_cast<double>(near) / row.children;
    row.cells_change = cells.median_of(relative_change);
}

} // namespace planula
