// SPDX-License-Identifier: MIT
#include "support/commands.h"

#include <boost/test/unit_test.hpp>

#include <regex>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

/// The departures of a tracked script as a table without its header, file names without folders and lines, which change
/// with every comment.
std::string table_of(const std::string &script) {
    const fs::path file = experiments_folder() / script;
    Said said = planula_says({"describe", file.string(), "--csv"});
    BOOST_TEST(said.code == 0, said.err);
    std::string text = said.out.substr(said.out.find('\n') + 1);
    const std::string library = experiments_folder().string() + "/";
    for (const std::string &folder :
         {file.parent_path().string() + "/", library, std::string("experiments/"), std::string("../")})
        for (std::size_t at = 0; (at = text.find(folder, at)) != text.npos;) text.erase(at, folder.size());
    return std::regex_replace(text, std::regex("\\.lua:[0-9]+"), ".lua");
}

/// What `planula describe` says of a setting with these keys, on the second line of small.lua.
std::string described(const std::string &keys, std::vector<std::string> words = {}) {
    const Workplace place("local paper = require 'paper'\nreturn paper.experiment { name = 'x', " + keys +
                          " }\n");
    words.insert(words.begin(), {"describe", place.script()});
    const Said said = planula_says(words);
    BOOST_TEST(said.code == 0, said.err);
    return said.out;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_paper_departs_in_nothing_from_itself) {
    BOOST_TEST(table_of("paper/replication.lua") == "");
    const Said said = planula_says({"describe", (experiments_folder() / "paper/replication.lua").string()});
    BOOST_TEST(said.out.ends_with(
                   "\nEvery setting is as in the paper: environment, functions, search, engine, start and "
                   "parameters.\n"),
               said.out);
}

BOOST_AUTO_TEST_CASE(each_variant_departs_in_what_it_states) {
    BOOST_TEST(table_of("variants/honey.lua") ==
               "honey,environment,drag normal,8 mass/cell²,1 mass/cell²,,honey.lua\n"
               "honey,environment,drag tangential,4 mass/cell²,0.1 mass/cell²,,honey.lua\n");
    BOOST_TEST(table_of("variants/moon.lua") ==
               "moon,environment,gravity,0.8333333333333334 cell/t.u.²,5 cell/t.u.²,,moon.lua\n");
    BOOST_TEST(table_of("variants/pareto.lua") == "pareto,search,search,nsga2,\"neat, novelty\",,\n");
    BOOST_TEST(table_of("variants/heading.lua") ==
               "heading,function,behaviour,heading.lua,paper/judgement.lua,,\n");
    BOOST_TEST(table_of("variants/current.lua") ==
               "current,environment,flow x,0.2 cell/t.u.,0 cell/t.u.,,current.lua\n"
               "current,function,fitness,current.lua,paper/judgement.lua,,\n");
    BOOST_TEST(table_of("variants/morphology-first.lua") ==
               "morphology-first,start,start,30 generations of novelty search on growth alone,generation 0 "
               "is random,,\n"
               "morphology-first,function,start.behaviour,descriptors/init.lua,none,,\"uses "
               "cells_per_niche = 16, "
               "longest = 8\"\n");
    BOOST_TEST(table_of("variants/stairs.lua") == "stairs,environment,ground,\"14 points, x from -60.00 to "
                                                  "60.00, height from 0.00 to 3.00\",flat,,stairs.lua\n");
}

BOOST_AUTO_TEST_CASE(a_departure_has_the_line_that_states_it) {
    const std::string table = described("environment = paper.aquatic { flow = { x = 2 } }", {"--csv"});
    BOOST_TEST(contains(table, "x,environment,flow x,2 cell/t.u.,0 cell/t.u.,,"), table);
    BOOST_TEST(contains(table, "small.lua:2\n"), table);
}

BOOST_AUTO_TEST_CASE(of_a_long_text_that_a_function_uses_the_beginning_is_shown) {
    const Workplace place(
        "local paper = require 'paper'\nlocal long, lines = ('é'):rep(500), 'a\\nb'\n"
        "return paper.experiment { name = 'x', fitness = function() return #long + #lines end }\n");
    const Said said = planula_says({"describe", place.script(), "--csv"});
    BOOST_TEST(contains(said.out, "é…\"\", a text of 1000 bytes"), said.out);
    BOOST_TEST(contains(said.out, "lines = \"\"a…\"\", a text of 3 bytes"), said.out);
}

BOOST_AUTO_TEST_CASE(what_the_paper_has_none_of_is_shown_once) {
    const std::string tide = table_of("variants/tide.lua"), later = table_of("variants/metamorphosis.lua");
    BOOST_TEST(
        tide ==
        "tide,environment,current,\"50 samples, one every 20 steps, again and again\",none,,tide.lua\n");
    BOOST_TEST(contains(later, "phase 1 gravity,5 cell/t.u.²,none,,from the parameter gravity\n"), later);
    BOOST_TEST(!contains(later, "phase 1 drag"), later);
    const std::string text = described(
        "search = 'nsga2', objectives = {\n"
        "{ name = 'size', value = function(life) return life.cells end, goal = 'maximise' },\n"
        "{ name = 'far', value = function(life) return life.displacement end, goal = 'maximise' } }");
    BOOST_TEST(contains(text, "objective size"), text);
    BOOST_TEST(!contains(text, "environment objective"), text);
    BOOST_TEST(contains(text, "as in the paper: environment"), text);
}

BOOST_AUTO_TEST_CASE(every_setting_of_a_study_departs_in_its_engine) {
    const std::string table = table_of("engines.lua");
    BOOST_TEST(std::count(table.begin(), table.end(), '\n') == 8);
    BOOST_TEST(contains(table, "osc-te-ns,engine,engine,bullet,native,,\n"), table);
    const Said said = planula_says({"describe", (experiments_folder() / "engines.lua").string()});
    BOOST_TEST(
        said.out.ends_with("\nall settings depart from the paper:\n  engine: bullet (paper: native)\n"),
        said.out);
}

BOOST_AUTO_TEST_CASE(a_function_is_shown_as_the_difference_of_sources) {
    const std::string text = described("penalty = function(life, parameters)\n"
                                       "  if life.outcome ~= \"viable\" then return 0 end\n"
                                       "  return 1\nend");
    BOOST_TEST(
        contains(
            text,
            "        function(life, parameters)\n"
            "          if life.outcome ~= \"viable\" then return 0 end\n"
            "      -   if life.births >= parameters.birth_limit then return parameters.birth_penalty end\n"
            "          return 1\n"
            "        end\n"
            "  as in the paper: environment, search, engine, start, parameters\n"),
        text);
}

BOOST_AUTO_TEST_CASE(a_function_of_the_same_meaning_is_as_in_the_paper) {
    const std::string text =
        described("behaviour = function(life) -- where it ended\n return {life.finish.x, life.finish.y} end");
    BOOST_TEST(text.ends_with(
                   "\nEvery setting is as in the paper: environment, functions, search, engine, start and "
                   "parameters.\n"),
               text);
}

BOOST_AUTO_TEST_CASE(a_function_of_the_same_text_that_uses_other_values_departs) {
    const Workplace place(
        "local paper = require 'paper'\nlocal math = { sqrt = function(x) return x end }\n"
        "return paper.experiment { name = 'x', fitness = function(life, parameters, p)\n"
        "  local dx = life.finish.x - life.rest.x\n"
        "  local dy = life.finish.y - life.rest.y\n"
        "  return (math.sqrt(dx * dx + dy * dy) + parameters.activity_bonus * life.activity) * p\n"
        "end }\n");
    const Said said = planula_says({"describe", place.script()});
    BOOST_TEST(contains(said.out, "the text is the paper's"), said.out);
    BOOST_TEST(contains(said.out, "math = a table"), said.out);
}

BOOST_AUTO_TEST_CASE(parameters_are_shown_with_origin_and_meaning) {
    const std::string text = described("title = 'X'", {"--population", "6", "--set", "drag_normal=2"});
    BOOST_TEST(contains(text, "\n  parameter population: 6 genomes (paper: 300, §2.7.2); "), text);
    // The world is made of it: it is shown once.
    BOOST_TEST(contains(text, "\n  environment drag normal: 2 mass/cell² (paper: 1 mass/cell²); from the\n"
                              "      parameter drag_normal\n"),
               text);
    BOOST_TEST(!contains(text, "parameter drag_normal:"), text);
    const std::string choice = described("title = 'X'", {"--set", "division_turn=daughter"});
    BOOST_TEST(contains(choice, "\n  parameter division_turn: daughter (paper: nobody, ours); "), choice);
    BOOST_TEST(contains(described("parameters = { niche_width = 2 }"), "changes nothing: its"));
}

BOOST_AUTO_TEST_CASE(what_all_settings_share_comes_first_and_once) {
    const Workplace place(
        "local paper = require 'paper'\nreturn paper.design { name = 'x',\n"
        "parameters = { generations = 7 }, settings = {\n"
        "{ name = 'a' }, { name = 'b', search = 'nsga2' }, { name = 'c', search = 'nsga2' } } }\n");
    const std::string text = planula_says({"describe", place.script()}).out;
    const std::size_t shared =
                          text.find("\nall settings depart from the paper:\n  parameter generations: 7 "),
                      own = text.find(
                          "\nb, c depart from the paper also:\n  search: nsga2 (paper: neat, novelty)\n");
    BOOST_TEST(shared != text.npos, text);
    BOOST_TEST(own != text.npos, text);
    BOOST_TEST(shared < own);
    BOOST_TEST(text.find("generations: 7") == text.rfind("generations: 7"), text);
}
