// SPDX-License-Identifier: MIT
// A whole evolution beside the library that the paper used: medians of a few runs on a task without simulator
// must fall within wide bands around the quartiles that MultiNEAT at d361660 shows over 50 runs of it.
#include "core/evolution/multineat_reference.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

using namespace planula;
using namespace planula::regression;

namespace {

constexpr int runs = 5;

/// The median of five runs may leave the quartiles by one and a half times their distance: nearly five of its
/// standard errors from the centre.
void compare(bool is_recurrent, int last) {
    std::vector<std::vector<Row>> rows;
    for (int seed = 1; seed <= runs; ++seed) rows.push_back(regression::evolve(is_recurrent, last, seed));
    for (const auto &row : rows) BOOST_TEST(row[5].threshold == 5 - 0.2 - 0.2 - 0.2 - 0.2 - 0.2);
    for (const Reference &reference : references) {
        if (reference.recurrent != is_recurrent || reference.generation > last) continue;
        std::vector<double> values;
        for (const auto &row : rows) values.push_back(row[reference.generation].*reference.value);
        std::sort(values.begin(), values.end());
        const double low = number(reference.low), high = number(reference.high);
        const double margin = 1.5 * (high - low) + 1e-9;
        BOOST_TEST_CONTEXT(reference.quantity << " in generation " << reference.generation) {
            BOOST_TEST(values[runs / 2] >= low - margin);
            BOOST_TEST(values[runs / 2] <= high + margin);
        }
    }
}

} // namespace

BOOST_AUTO_TEST_CASE(feed_forward_evolution_runs_like_multineat) { compare(false, 50); }
BOOST_AUTO_TEST_CASE(recurrent_evolution_runs_like_multineat) { compare(true, 20); }

BOOST_AUTO_TEST_CASE(printed_numbers_show_how_far_they_are_rounded) {
    BOOST_TEST(rounding("300") == 0.5);
    BOOST_TEST(std::abs(rounding("0.375") - 0.0005) < 1e-15);
    BOOST_TEST(std::abs(rounding("3.9e-4") - 0.5e-5) < 1e-15);
    BOOST_TEST(std::size(references) == 6u * (8 + 4));
    for (const Reference &reference : references) {
        BOOST_TEST(number(reference.low) <= number(reference.median));
        BOOST_TEST(number(reference.median) <= number(reference.high));
    }
}
