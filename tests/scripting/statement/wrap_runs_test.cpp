// SPDX-License-Identifier: MIT
#include "statement/wrap_runs.h"

#include "scripting/statement/statistics_in_lua.h"

#include <boost/test/unit_test.hpp>

#include <set>

using namespace planula;
using test::number;

namespace {

std::string refusal(const std::string &expression) {
    return test::refusal_of_table("return { { x = " + expression + " } }");
}

} // namespace

BOOST_AUTO_TEST_CASE(settings_are_found_by_name_and_by_number) {
    BOOST_TEST(number("#runs") == 2); // that have runs
    BOOST_TEST(number("#runs.ns") == 3);
    BOOST_TEST(number("#runs['neat']") == 3);
    BOOST_TEST(number("runs[2].name == 'neat' and 1 or 0") == 1);
    BOOST_TEST(number("runs[3] == nil and 1 or 0") == 1);
    BOOST_TEST(number("runs.ns.generations") == 10);
    BOOST_TEST(number("runs.ns.population") == 10);
    BOOST_TEST(number("runs.ns[2].seed") == 2);
    BOOST_TEST(number("runs.ns[4] == nil and 1 or 0") == 1);
    BOOST_TEST(number("sum",
                      "local sum = 0 for _, setting in ipairs(runs) do for _, run in ipairs(setting) do "
                      "sum = sum + run.best_fitness[1] end end") == 22);
}

BOOST_AUTO_TEST_CASE(a_value_is_of_a_run_or_a_list_of_all_runs) {
    test::FakeRuns runs;
    runs.settings[0].histories[1].generations[4].mean_fitness = 6.5;
    runs.settings[0].histories[1].after.at(5).champion.cells = 33;
    BOOST_TEST(number("runs.ns[2].mean_fitness[5]", "", runs) == 6.5);
    BOOST_TEST(number("runs.ns.mean_fitness[5][2]", "", runs) == 6.5);
    BOOST_TEST(number("runs.ns.mean_fitness[6][2]", "", runs) == 0);
    BOOST_TEST(number("#runs.ns.mean_fitness[5]", "", runs) == 3);
    BOOST_TEST(number("runs.ns[2].champion.cells[5]", "", runs) == 33);
    BOOST_TEST(number("runs.ns.champion.cells[5][2]", "", runs) == 33);
    BOOST_TEST(number("#runs.ns[1].best_fitness") == 10);
    BOOST_TEST(number("runs.neat[3].size_entropy[10]") == 7);
    BOOST_TEST(number("runs.neat[3].side_switches[10]") == 7);
}

BOOST_AUTO_TEST_CASE(every_field_can_be_read_and_is_described) {
    std::set<std::string_view> names;
    for (const RunField &field : run_fields()) {
        BOOST_TEST(names.insert(field.name).second, field.name);
        BOOST_TEST(!field.meaning.empty(), field.name);
        BOOST_TEST(!field.unit.empty(), field.name);
        BOOST_TEST(number("#runs.ns." + std::string(field.name) + "[10]") == 3, field.name);
    }
    for (const char *needed :
         {"best_fitness", "mean_fitness", "size_entropy", "fitness_spread", "direction_resultant",
          "side_switches", "heredity_fitness", "archive", "cyclic"})
        BOOST_TEST(names.contains(needed), needed);
    std::set<std::string_view> champion;
    for (const RunField &field : champion_fields()) {
        champion.insert(field.name);
        BOOST_TEST(number("#runs.ns.champion." + std::string(field.name) + "[10]") == 3, field.name);
    }
    for (const char *needed : {"fitness", "elongation", "late_share", "late_actuation", "cells", "genome"})
        BOOST_TEST(champion.contains(needed), needed);
}

BOOST_AUTO_TEST_CASE(a_value_that_is_missing_is_false) {
    test::FakeRuns runs;
    runs.settings[0].histories[1].after.at(5).direction_resultant = std::nullopt;
    BOOST_TEST(number("runs.ns[2].direction_resultant[5] == false and 1 or 0", "", runs) == 1);
    BOOST_TEST(number("#runs.ns.direction_resultant[5]", "", runs) == 3);
    BOOST_TEST(number("#stats.present(runs.ns.direction_resultant[5])", "", runs) == 2);
    BOOST_TEST(number("stats.present(runs.ns.direction_resultant[5])[2]", "", runs) == 3);
}

BOOST_AUTO_TEST_CASE(end_points_and_the_archive_are_lists_whose_generations_count_from_1) {
    BOOST_TEST(number("runs.ns[2].endpoints[1].generation") == 5);
    BOOST_TEST(number("runs.ns[2].endpoints[1].x") == 1.5);
    BOOST_TEST(number("runs.ns[2].endpoints[1].y") == 1);
    BOOST_TEST(number("#runs.ns[1].archive") == 2);
    BOOST_TEST(number("runs.ns[1].archive[1].generation") == 3);
    BOOST_TEST(number("runs.ns[1].archive[1].fitness") == 9);
    BOOST_TEST(number("#runs.ns[1].archive[1].behaviour") == 3);
    BOOST_TEST(number("runs.ns[1].archive[1].behaviour[3]") == 3);
}

BOOST_AUTO_TEST_CASE(an_unknown_name_is_an_error_with_its_line_and_the_nearest_name) {
    BOOST_TEST(test::contains(refusal("runs.nss"),
                              "test.lua:2: runs has no 'nss'; did you mean 'ns'? (allowed: ns, neat"));
    BOOST_TEST(test::contains(refusal("runs.ns.best_fitnes"),
                              "a setting has no 'best_fitnes'; did you mean 'best_fitness'?"));
    BOOST_TEST(test::contains(refusal("runs.ns[1].sed"), "a run has no 'sed'; did you mean 'seed'?"));
    BOOST_TEST(test::contains(refusal("runs.ns.champion.elongations[1]"),
                              "champion has no 'elongations'; did you mean 'elongation'?"));
    BOOST_TEST(test::contains(refusal("runs.ns.generation"), "did you mean 'generations'?"));
    for (const char *key : {"true", "{}", "runs", "print"})
        BOOST_TEST(test::contains(refusal("runs[" + std::string(key) + "]"), "test.lua:2: "), key);
}

BOOST_AUTO_TEST_CASE(generations_are_whole_numbers_from_1_to_the_last) {
    for (const char *g : {"0", "-1", "1.5", "0 / 0", "math.huge", "'a'", "{}"})
        BOOST_TEST(
            test::contains(refusal("runs.ns.best_fitness[" + std::string(g) + "]"),
                           "test.lua:2: best_fitness[g] is the value after g generations: g is a whole "
                           "number from 1 to 10"),
            g);
    BOOST_TEST(
        test::contains(refusal("runs.ns.best_fitness[11]"),
                       "test.lua:2: the runs of ns have 10 generations, and best_fitness[11] was asked for"));
}

BOOST_AUTO_TEST_CASE(runs_are_read_only_and_opaque) {
    for (const char *write : {"runs.ns = 1", "runs.ns.name = 'x'", "runs.ns[1].seed = 2",
                              "runs.ns.best_fitness[1] = 3", "runs.ns.champion.fitness = 1"})
        BOOST_TEST(test::contains(test::refusal_of_table(std::string(write) + " return {}"),
                                  "test.lua:2: runs are read-only"),
                   write);
    BOOST_TEST(test::refusal_of_table("pairs(runs) return {}") != "");
    BOOST_TEST(test::refusal_of_table("return runs") != "");
    BOOST_TEST(number("tostring(runs) == 'userdata' and 1 or 0") == 1);
}

BOOST_AUTO_TEST_CASE(what_is_asked_for_and_is_not_there_is_noted) {
    const test::FakeRuns runs;
    const auto ask = [&](const std::string &expression) {
        Asked asked;
        test::table("local x = " + expression + " return { columns = { 'a' } }", runs, asked);
        return asked;
    };
    Asked asked = ask("runs.neat.best_fitness[7]");
    BOOST_TEST(!asked.missing);
    BOOST_TEST(asked.generations == 7);
    BOOST_REQUIRE(asked.settings.size() == 1u);
    BOOST_TEST(asked.settings[0]->spec->name == "neat");
    asked = ask("runs.ns.best_fitness[11]");
    BOOST_TEST(asked.missing);
    BOOST_TEST(asked.generations == 11);
    asked = ask("runs.other");
    BOOST_TEST(asked.missing);
    BOOST_TEST(asked.settings.at(0)->spec->name == "other");
    // Also if the script catches the error.
    BOOST_TEST(ask("pcall(function() return runs.other end)").missing);
}
