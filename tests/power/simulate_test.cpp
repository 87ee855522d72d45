// SPDX-License-Identifier: MIT
// What `make power` keeps beside this file: its error rates are those that are promised, and a small simulation agrees
// with it.
#include "power/simulate.h"

#include "base/text.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

using namespace planula;

namespace {

/// The rows of a kept table, split at commas, without its header.
std::vector<std::vector<std::string>> kept(const std::string &name) {
    const std::string folder = PLANULA_SOURCE_DIR "/tests/power/";
    std::ifstream file(folder + name);
    std::vector<std::vector<std::string>> rows;
    std::string line;
    std::getline(file, line);
    while (std::getline(file, line)) {
        auto &cells = rows.emplace_back(1);
        for (const char letter : line) {
            if (letter == ',')
                cells.emplace_back();
            else
                cells.back() += letter;
        }
    }
    return rows;
}

double number(const std::string &text) { return parse_double(text).value(); }

/// Whether a share of so few repetitions can be one of the kept share: four standard deviations, and one repetition.
bool agrees(double share, double expected, int repetitions) {
    return std::abs(share - expected) <
           4 * std::sqrt(expected * (1 - expected) / repetitions) + 1.0 / repetitions;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_error_rate_of_every_test_is_at_most_the_stated_one) {
    int checked = 0;
    for (const auto &row : kept("power.csv")) {
        const std::string &test = row[0], &truth = row[1];
        const double reproduced = number(row[4]), contradicted = number(row[5]);
        const bool equivalence = test.starts_with("equivalence"), gaits = test.starts_with("cyclic");
        const std::string what = test + ": " + truth;
        const auto check = [&](double rate, double most) {
            BOOST_TEST(rate < most, what);
            ++checked;
        };
        // Where nothing differs, 5 % both ways together; of unequal spreads the rank-sum test promises nothing.
        if (!equivalence && truth.starts_with("A12 = 0.5"))
            check(reproduced + contradicted, truth.ends_with("spread") ? 0.08 : 0.0575);
        // Where the difference is as large as the bound, 5 % are called none.
        if (equivalence && truth.starts_with("A12 = 0.71")) check(reproduced, 0.0575);
        if (gaits && truth == "share without 0.25") check(reproduced, 0.0575);
        if (equivalence && truth.starts_with("A12 = 0.5") && truth != "A12 = 0.56")
            check(contradicted, 0.0575);
    }
    BOOST_TEST(checked == 18);
}

BOOST_AUTO_TEST_CASE(a_small_simulation_agrees_with_the_kept_one) {
    constexpr int repetitions = 100;
    const auto rows = kept("power.csv");
    const auto found = power::outcomes(repetitions);
    BOOST_REQUIRE(rows.size() == found.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const power::Outcome &row = found[i];
        const std::string what = row.test + ": " + row.truth;
        BOOST_TEST((rows[i][0] == row.test && rows[i][1] == row.truth), what);
        BOOST_TEST(agrees(row.reproduced, number(rows[i][4]), repetitions), what);
        BOOST_TEST(agrees(row.contradicted, number(rows[i][5]), repetitions), what);
    }
}

BOOST_AUTO_TEST_CASE(intervals_cover_as_often_as_is_stated) {
    constexpr int repetitions = 100;
    const auto rows = kept("coverage.csv");
    const auto found = power::coverages(repetitions);
    BOOST_REQUIRE(rows.size() == found.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        BOOST_TEST(agrees(found[i].covered, number(rows[i][4]), repetitions),
                   found[i].interval + ": " + found[i].values);
}
