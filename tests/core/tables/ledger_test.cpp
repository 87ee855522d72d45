// SPDX-License-Identifier: MIT
#include "tables/ledger.h"

#include <algorithm>
#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

const LedgerRow &row_of(const std::vector<LedgerRow> &rows, const std::string &name) {
    return *std::find_if(rows.begin(), rows.end(), [&](const LedgerRow &row) { return row.name == name; });
}

} // namespace

BOOST_AUTO_TEST_CASE(the_ledger_has_every_parameter_with_its_standard) {
    const std::vector<Parameters> one(1);
    const auto rows = ledger(one);
    BOOST_TEST(rows.size() == parameter_rows().size());
    for (const LedgerRow &row : rows) BOOST_TEST(row.value == row.standard, row.name);
    BOOST_TEST(row_of(rows, "population").standard == "300");
    BOOST_TEST(
        row_of(rows, "division_turn").standard ==
        value_text(parameter_row("division_turn"), static_cast<int>(Parameters{}.development.division_turn)));
    BOOST_TEST(row_of(rows, "population").section == "NEAT");
}

BOOST_AUTO_TEST_CASE(a_value_that_settings_do_not_share_is_left_out) {
    std::vector<Parameters> two(2);
    for (Parameters &parameters : two) parameters.neat.population = 30;
    two[1].land.gravity = 1;
    const auto rows = ledger(two);
    BOOST_TEST(row_of(rows, "population").value == "30");
    BOOST_TEST(row_of(rows, "gravity").value == "");
    BOOST_TEST(row_of(rows, "gravity").standard == "5");
}
