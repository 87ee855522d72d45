// SPDX-License-Identifier: MIT
#include "support/commands.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

BOOST_AUTO_TEST_CASE(sensitivity_has_a_row_for_each_parameter_and_factor_that_concern_the_setting) {
    const Workplace place(
        replaced(replaced(small, "population = 6", "population = 30"), "name = 'small'",
                 "name = 'small', sensitivity = { sample = 20, factors = { 0.5, 2 },\n"
                 "parameters = { 'drag_normal', 'gravity', 'minimum_cells', 'knot_interval' } }"));
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2", "--generations", "1"}).code == 0);
    const std::string data = place.path / "data";
    const Said said = planula_says({"sensitivity", place.script(), "--runs", place.runs(), "--out", data,
                                    "--threads", "2", "--generations", "1"});
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.out == data + '\n');
    BOOST_TEST(contains(said.err, "sensitivity: drag_normal, 1 of 4\n"), said.err);
    BOOST_TEST(contains(said.err, "knot_interval = 20 is passed over: parameters break the rule: "
                                  "update_interval is a multiple of knot_interval\n"),
               said.err);
    const std::string table = content(std::filesystem::path(data) / "sensitivity.csv");
    for (const char *row : {"\nsmall,drag_normal,1,0.5,30,1,20,", "\nsmall,drag_normal,1,2,30,1,20,",
                            "\nsmall,minimum_cells,8,4,30,1,20,", "\nsmall,minimum_cells,8,16,30,1,20,"})
        BOOST_TEST(contains(table, row), table);
    BOOST_TEST(contains(table, "\nsmall,knot_interval,10,5,"), table);
    BOOST_TEST(!contains(table, "\nsmall,knot_interval,10,20,"), table);
    BOOST_TEST(!contains(table, "gravity"), table);
}
