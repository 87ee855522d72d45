// SPDX-License-Identifier: MIT
#include "support/commands.h"

#include "statement/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

/// What `planula check` says of a text after `local paper = require "paper"` on the first line.
Said check(const std::string &text, std::vector<std::string> words = {}) {
    const Workplace place("local paper = require 'paper'\n" + text);
    words.insert(words.begin(), {"check", place.script(), "--threads", "1"});
    return planula_says(words);
}

/// The statement of one setting with these keys, on the second line.
std::string setting(const std::string &keys) {
    return "return paper.experiment { name = 'x', " + keys + " }\n";
}

void check_warns(const std::string &text, const std::string &warning) {
    const Said said = check(text);
    BOOST_TEST(said.code == 0, said.err);
    BOOST_TEST(said.err.starts_with("warning: "), said.err);
    BOOST_TEST(contains(said.err, warning), said.err);
    BOOST_TEST(contains(said.out, "ok: "), said.out);
}

void check_fails(const std::string &text, const std::string &error) {
    const Said said = check(text);
    BOOST_TEST(said.code == 65, said.out + said.err);
    BOOST_TEST(contains(said.err, error), said.err);
    BOOST_TEST(said.out == "");
}

void check_is_quiet(const std::string &text) {
    const Said said = check(text, {"--quick"});
    BOOST_TEST(said.code == 0);
    BOOST_TEST(said.err == "");
}

} // namespace

BOOST_AUTO_TEST_CASE(a_sound_script_is_ok_with_an_estimate) {
    const Said said = check(setting("search = 'novelty', parameters = { generations = 5 }"));
    BOOST_TEST(said.code == 0);
    BOOST_TEST(said.err == "");
    for (const char *part : {"ok: ", "small.lua: x, 1 setting: x\n", "trial lives: 8 of 8 end viable",
                             "estimated: 20 runs, 30000 evaluations\n", "\n  time    ", " core-hours (",
                             "\n  disk    ", "\n  memory  "})
        BOOST_TEST(contains(said.out, part), said.out);
    for (const char *part : {"inf ", "nan"}) BOOST_TEST(!contains(said.out, part), said.out);
    const Said fewer =
        check(setting("parameters = { generations = 5 }"), {"--seeds", "1:3", "--population", "100"});
    BOOST_TEST(contains(fewer.out, "estimated: 3 runs, 1500 evaluations\n"), fewer.out);
}

BOOST_AUTO_TEST_CASE(a_quick_check_simulates_nothing) {
    const Said said = check(setting("penalty = function() return 0 end"), {"--quick"});
    BOOST_TEST(said.code == 0);
    BOOST_TEST(said.err == "");
    BOOST_TEST(said.out.ends_with("small.lua: x, 1 setting: x\n"), said.out);
}

BOOST_AUTO_TEST_CASE(strict_makes_warnings_errors) {
    const std::string zero = setting("penalty = function() return 0 end");
    const Said said = check(zero, {"--strict"});
    BOOST_TEST(said.code == 65);
    BOOST_TEST(contains(said.err, "small.lua:2: penalty is 0 for all 8 trial lives"), said.err);
    BOOST_TEST(!contains(said.err, "warning"), said.err);
}

BOOST_AUTO_TEST_CASE(a_penalty_with_which_nobody_is_valid_is_found) {
    check_warns("local function penalty(life)\nreturn life.cells > 10000 and 1 or 0\nend\n" +
                    setting("penalty = penalty"),
                "small.lua:2: penalty is 0 for all 8 trial lives that end viable: nobody would be valid");
    check_warns(setting("penalty = function(life) return life.cells / 40 end"),
                "small.lua:2: penalty returned a number above 1 for ");
}

BOOST_AUTO_TEST_CASE(values_that_are_never_allowed_are_errors) {
    check_fails(
        setting("fitness = function(life) return -life.displacement end"),
        "small.lua:2: fitness returned a number below 0 for all 8 trial lives of evolved specimens; such "
        "individuals count as not valid");
    check_fails(setting("fitness = function(life) return 0 / 0 end"), "small.lua:2: fitness returned ");
    check_fails(setting("search = 'novelty', behaviour = function(life) return { life.finish.x / 0 } end"),
                "small.lua:2: behaviour returned ");
}

BOOST_AUTO_TEST_CASE(values_that_are_not_allowed_for_some_are_warnings) {
    check_warns(setting("fitness = function(life) return life.cells - 30 end"),
                "small.lua:2: fitness returned a number below 0 for ");
    check_warns(setting("behaviour = function(life)\nif life.cells < 40 then return { 1 } end\n"
                        "return { life.cells, 2 } end, search = 'novelty'"),
                "small.lua:2: behaviour returned ");
}

BOOST_AUTO_TEST_CASE(a_function_that_fails_for_real_lives_alone_is_an_error) {
    check_fails(setting("fitness = function(life)\nlocal last = life.path[41]\n"
                        "return life.elongation > 2 and last.nothing.x or 1 end"),
                "small.lua:4: ");
    check_fails(setting("fitness = function(life) return life.elongation == 2 and 1 or 'far' end"),
                "small.lua:2: fitness returned string, not a number for ");
}

BOOST_AUTO_TEST_CASE(results_that_are_the_same_for_all_are_found) {
    check_warns(setting("fitness = function() return 3 end"),
                "small.lua:2: fitness is 3 for all 8 trial lives: it tells nobody apart");
    check_warns(setting("search = 'novelty',\nbehaviour = function(life) return { 0, 1 } end"),
                "small.lua:3: behaviour is {0, 1} for all 8 trial lives: it tells nobody apart");
    check_warns(setting("search = 'map-elites',\nbehaviour = function(life) return { life.cells, 0 } end"),
                "small.lua:3: number 2 of behaviour is 0 for all 8 trial lives");
    check_warns(setting("start = { generations = 2,\nbehaviour = function(life) return { 7 } end }"),
                "small.lua:3: start.behaviour is {7} for all 8 trial lives");
}

BOOST_AUTO_TEST_CASE(a_behaviour_that_no_search_reads_is_found) {
    check_warns(setting("behaviour = function(life) return { life.cells } end"),
                "small.lua:2: behaviour is not read: the search 'neat' rewards fitness alone");
    check_is_quiet(setting("search = 'novelty', behaviour = function(life) return { life.cells } end"));
}

BOOST_AUTO_TEST_CASE(an_environment_in_which_nobody_lives_or_moves_is_found) {
    check_warns(setting("environment = paper.terrestrial {\ngravity = 100000 }"),
                "none of 8 trial lives ends viable (8 exploded): this world may be too violent");
    check_warns(
        setting(
            "environment = paper.terrestrial(), parameters = {\nsettle_limit = 100, settle_window = 100 }"),
        "trial lives ends viable (8 never_settled): no body comes to rest before it would move");
    check_warns(setting("environment = paper.aquatic {\nactuation_range = 0 }"),
                "nobody moves: all 8 trial lives end within 0.01 cells of where they began");
    check_warns(setting("parameters = {\nminimum_cells = 250, cell_limit = 256 }"),
                "small.lua:2: none of 8 trial lives ends viable (8 too_small): no specimen grows a body");
}

BOOST_AUTO_TEST_CASE(numbers_of_the_environment_without_effect_are_found) {
    check_warns(setting("environment = paper.aquatic {\nfriction = 0.5 }"),
                "small.lua:3: friction = 0.5 changes nothing: all 8 trial lives are the same with 0");
    const Said said = check(setting("environment = paper.aquatic { flow = { x = 0.5, y = 0 } }"));
    BOOST_TEST(said.err == "");
}

BOOST_AUTO_TEST_CASE(parameters_that_nothing_reads_are_found) {
    check_warns(setting("environment = paper.aquatic {\ndrag = { normal = 8, tangential = 4 } },\n"
                        "parameters = { drag_normal = 5 }"),
                "small.lua:4: parameters.drag_normal = 5 changes nothing: ");
    const Said said =
        check("return paper.design { name = 'x',\nparameters = { niche_width = 3 }, settings = {\n"
              "{ name = 'a', environment = paper.terrestrial(),\nparameters = { drag_normal = 5 } },\n"
              "{ name = 'b' } } }\n",
              {"--quick"});
    BOOST_TEST(said.err.starts_with("warning: "));
    BOOST_TEST(contains(said.err,
                        "small.lua:3: parameters.niche_width = 3 changes nothing: the setting's search is "
                        "'neat', which keeps no map\n"),
               said.err);
    BOOST_TEST(
        contains(said.err,
                 "small.lua:5: parameters.drag_normal = 5 changes nothing: the setting's environment has "
                 "no drag normal (setting a)\n"),
        said.err);
}

BOOST_AUTO_TEST_CASE(a_parameter_that_one_setting_reads_may_stand_in_all) {
    check_is_quiet("return paper.design { name = 'x', parameters = { niche_width = 3 }, settings = {\n"
                   "{ name = 'a' }, { name = 'b', search = 'map-elites' } } }\n");
    // A function reads it.
    check_is_quiet(setting("parameters = { niche_width = 3 },\n"
                           "fitness = function(life, parameters, p) return p * parameters.niche_width end"));
}

BOOST_AUTO_TEST_CASE(what_is_overridden_everywhere_is_found) {
    const Said said = check(
        "return paper.design { name = 'x',\nparameters = { population = 30, generations = 7 }, settings = {\n"
        "{ name = 'a', parameters = { population = 10 } },\n"
        "{ name = 'b', parameters = { population = 20, seeds = 4 } } } }\n",
        {"--quick"});
    BOOST_TEST(contains(said.err, "small.lua:3: parameters.population is overridden in every setting\n"),
               said.err);
    BOOST_TEST(
        contains(said.err,
                 "small.lua:5: parameters.seeds = 4 is not read: every setting has as many seeds as the "
                 "first, 20; state it beside settings (setting b)\n"),
        said.err);
    BOOST_TEST(!contains(said.err, "generations"), said.err);
}

BOOST_AUTO_TEST_CASE(names_that_are_used_nowhere_are_found) {
    const Said said = check(
        "local function cost(life)\nreturn life.activity\nend\nlocal limit = 3\nlocal _spare = limit\n" +
            setting("title = 'no cost'"),
        {"--quick"});
    BOOST_TEST(contains(said.err, "small.lua:2: 'cost' is defined and used nowhere\n"), said.err);
    BOOST_TEST(!contains(said.err, "limit"), said.err);
    BOOST_TEST(!contains(said.err, "_spare"), said.err);
}

BOOST_AUTO_TEST_CASE(settings_that_share_a_fault_share_a_line) {
    const Said said =
        check("local function flat() return 1 end\nreturn paper.design { name = 'x', settings = {\n"
              "{ name = 'a', fitness = flat }, { name = 'b', fitness = flat }, { name = 'c' } } }\n");
    BOOST_TEST(replaced(said.err, "fitness is 1", "").size() > 0u);
    BOOST_TEST(std::count(said.err.begin(), said.err.end(), '\n') == 1, said.err);
    BOOST_TEST(contains(said.err, "it tells nobody apart (settings a, b)\n"), said.err);
}

BOOST_AUTO_TEST_CASE(every_tracked_script_passes) {
    for (const fs::path &file : experiment_files()) {
        const Said said = planula_says({"check", file.string(), "--quick"});
        BOOST_TEST(said.code == 0, file);
        BOOST_TEST(said.err == "", said.err);
    }
}

BOOST_AUTO_TEST_CASE(every_variant_passes_its_trial_lives) {
    for (const fs::path &file : experiment_files()) {
        if (file.parent_path().filename() != "variants") continue;
        const Said said = planula_says({"check", file.string()});
        BOOST_TEST(said.code == 0, file);
        BOOST_TEST(said.err == "", said.err);
    }
}

BOOST_AUTO_TEST_CASE(specimens_of_both_actuations_are_there_and_damaged_ones_are_refused) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        BOOST_TEST(specimens(experiments_folder(), actuation).size() == 8u);
    const Folder folder;
    BOOST_TEST(contains(refusal([&] { specimens(folder.path, Actuation::grn); }), "specimens.csv"));
    const std::string text = content(experiments_folder() / "specimens.csv");
    test::write(folder.path / "specimens.csv", text.substr(0, text.find('\n') + 1));
    BOOST_TEST(contains(refusal([&] { specimens(folder.path, Actuation::grn); }), "no genome fits"));
    test::write(folder.path / "specimens.csv", text.substr(0, text.size() / 2) + "\n0,link,x\n");
    BOOST_TEST(contains(refusal([&] { specimens(folder.path, Actuation::oscillator); }), "specimens.csv:"));
}
