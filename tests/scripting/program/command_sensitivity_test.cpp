// SPDX-License-Identifier: MIT
#include "support/commands.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

BOOST_AUTO_TEST_CASE(sensitivity_has_a_row_for_each_factor_of_each_parameter_that_the_setting_reads) {
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
    BOOST_TEST(contains(said.err, "knot_interval = 20 is skipped: parameters break the rule: "
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

BOOST_AUTO_TEST_CASE(sensitivity_varies_the_numbers_that_an_environment_states_itself) {
    const auto table_with = [](const std::string &drag) {
        const Workplace place(
            replaced(replaced(small, "population = 6", "population = 30"), "name = 'small'",
                     "name = 'small', sensitivity = { sample = 20, factors = { 2 },\n"
                     "parameters = { 'drag_normal', 'drag_tangential', 'actuation_range_aquatic' } },\n"
                     "environment = paper.aquatic { drag = " +
                         drag + " }"));
        BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "1"}).code == 0);
        const std::string data = place.path / "data";
        const std::vector<std::string> where{place.script(), "--runs",        place.runs(), "--out",
                                             data,           "--generations", "1"};
        for (const std::string command : {"sensitivity", "reduce"}) {
            std::vector<std::string> words{command};
            words.insert(words.end(), where.begin(), where.end());
            const Said said = planula_says(words);
            BOOST_REQUIRE_MESSAGE(said.code == 0, said.err);
        }
        return content(std::filesystem::path(data) / "sensitivity.csv") +
               content(std::filesystem::path(data) / "worlds.csv") +
               content(std::filesystem::path(data) / "parameters.csv");
    };
    const std::string by_number = table_with("{ normal = 8, tangential = 4 }");
    for (const char *row : {"\nsmall,drag_normal,8,16,", "\nsmall,drag_tangential,4,8,",
                            "\nsmall,actuation_range_aquatic,0.4,0.8,", "\nsmall,drag normal,8,mass/cell²,\n",
                            "\nsmall,actuation_range,0.4,rest length,actuation_range_aquatic\n",
                            "\nWater,drag_normal,,1,", "\nWater,actuation_range_aquatic,0.4,0.4,"})
        BOOST_TEST(contains(by_number, row), row << by_number);
    // Twice the drag changes something.
    BOOST_TEST(!contains(by_number, "8,16,30,1,20,1,1,1,1,1,1,1"), by_number);

    // The standard values as numbers give the rows of the parameters by name.
    const std::string standard = table_with("{ normal = 1, tangential = 0.1 }"),
                      by_name = table_with("{ normal = 'drag_normal', tangential = 'drag_tangential' }");
    const auto rows = [](const std::string &text) { return text.substr(0, text.find("setting,quantity")); };
    BOOST_TEST(rows(standard) == rows(by_name));
}
