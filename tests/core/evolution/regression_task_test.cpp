// SPDX-License-Identifier: MIT
// A whole evolution beside the library that the paper used: medians of a few runs on a task without simulator
// must fall within wide bands around the quartiles that MultiNEAT at d361660 shows over 50 runs of it.
#include "core/evolution/regression_task.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <vector>

using namespace planula;
using regression::Row;

namespace {

/// Quartiles of MultiNEAT at one generation.
struct Reference {
    int generation;
    double Row::*quantity;
    const char *name;
    double low, high;
};

constexpr std::array feed_forward{
    Reference{0, &Row::shortfall, "10 - best", 0.19, 0.39},
    Reference{0, &Row::mean_fitness, "mean fitness", 6.82, 6.93},
    Reference{0, &Row::weight_deviation, "weight s.d.", 0.407, 0.409},
    Reference{5, &Row::mean_fitness, "mean fitness", 8.88, 9.06},
    Reference{5, &Row::species, "species", 1, 2},
    Reference{10, &Row::shortfall, "10 - best", 0.0021, 0.0055},
    Reference{10, &Row::mean_fitness, "mean fitness", 8.62, 8.91},
    Reference{10, &Row::species, "species", 7, 11},
    Reference{10, &Row::threshold, "threshold", 3.2, 3.8},
    Reference{10, &Row::links, "links", 55.3, 56.8},
    Reference{10, &Row::hidden, "hidden", 1.02, 1.57},
    Reference{10, &Row::weight_deviation, "weight s.d.", 0.47, 0.52},
    Reference{10, &Row::largest, "largest species", 40, 84},
    Reference{20, &Row::mean_fitness, "mean fitness", 9.03, 9.18},
    Reference{20, &Row::species, "species", 14.3, 17.8},
    Reference{20, &Row::threshold, "threshold", 4.8, 5.6},
    Reference{20, &Row::links, "links", 57.2, 58.7},
    Reference{20, &Row::hidden, "hidden", 1.97, 2.41},
    Reference{20, &Row::weight_deviation, "weight s.d.", 0.51, 0.59},
    Reference{20, &Row::largest, "largest species", 30, 39},
    Reference{50, &Row::mean_fitness, "mean fitness", 9.07, 9.20},
    Reference{50, &Row::species, "species", 13, 15.8},
    Reference{50, &Row::threshold, "threshold", 10.8, 11.6},
    Reference{50, &Row::links, "links", 60.2, 61.9},
    Reference{50, &Row::hidden, "hidden", 2.54, 3.06},
    Reference{50, &Row::weight_deviation, "weight s.d.", 0.57, 0.66},
    Reference{50, &Row::largest, "largest species", 24, 42},
};

constexpr std::array recurrent{
    Reference{0, &Row::shortfall, "10 - best", 0.14, 0.28},
    Reference{0, &Row::mean_fitness, "mean fitness", 7.12, 7.21},
    Reference{5, &Row::mean_fitness, "mean fitness", 9.08, 9.21},
    Reference{5, &Row::species, "species", 1, 2},
    Reference{10, &Row::mean_fitness, "mean fitness", 8.85, 9.12},
    Reference{10, &Row::species, "species", 7.3, 11},
    Reference{10, &Row::threshold, "threshold", 3.2, 3.6},
    Reference{20, &Row::mean_fitness, "mean fitness", 9.22, 9.33},
    Reference{20, &Row::species, "species", 14, 18},
    Reference{20, &Row::threshold, "threshold", 5, 5.4},
};

constexpr int runs = 5;

/// The median of five runs may leave the quartiles by one and a half times their distance: nearly five of its
/// standard errors from the centre.
template <std::size_t N> void compare(bool is_recurrent, const std::array<Reference, N> &references) {
    std::vector<std::vector<Row>> rows;
    const int last = references.back().generation;
    for (int seed = 1; seed <= runs; ++seed) rows.push_back(regression::evolve(is_recurrent, last, seed));
    for (const auto &row : rows) BOOST_TEST(row[5].threshold == 5 - 0.2 - 0.2 - 0.2 - 0.2 - 0.2);
    for (const auto &reference : references) {
        std::vector<double> values;
        for (const auto &row : rows) values.push_back(row[reference.generation].*reference.quantity);
        std::sort(values.begin(), values.end());
        const double margin = 1.5 * (reference.high - reference.low);
        BOOST_TEST_CONTEXT(reference.name << " in generation " << reference.generation) {
            BOOST_TEST(values[runs / 2] >= reference.low - margin);
            BOOST_TEST(values[runs / 2] <= reference.high + margin);
        }
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(feed_forward_evolution_runs_like_multineat) { compare(false, feed_forward); }
BOOST_AUTO_TEST_CASE(recurrent_evolution_runs_like_multineat) { compare(true, recurrent); }
