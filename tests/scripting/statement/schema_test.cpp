// SPDX-License-Identifier: MIT
#include "statement/schema.h"

#include "statement/schema_environment.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;

namespace {

Experiment experiment(const std::string &text, const Overrides &overrides = {}) {
    return load_experiment(test::script("local paper = require 'paper'\n" + text), overrides);
}

std::string refused(const std::string &text) {
    return test::refusal([&] { experiment(text); });
}

// A one-setting experiment; `body` starts on line 3.
std::string refused_body(const std::string &body) {
    return refused("return paper.experiment { name = 'x',\n" + body + "\n}");
}

World environment_of(const std::string &table) {
    const Experiment e = experiment("return paper.experiment { name = 'x', environment = " + table + " }");
    return {e.settings[0].environment, e.settings[0].actuation_range};
}

} // namespace

BOOST_AUTO_TEST_CASE(a_statement_is_completed_by_the_paper) {
    const Experiment e =
        experiment("return paper.experiment { name = 'honey', environment = paper.aquatic { drag = { "
                   "normal = 8, tangential = 4 } } }");
    BOOST_REQUIRE_EQUAL(e.settings.size(), 1u);
    const Spec &spec = e.settings[0];
    BOOST_TEST(spec.name == "honey");
    BOOST_TEST((spec.actuation == Actuation::oscillator));
    BOOST_TEST(spec.search == "neat");
    BOOST_TEST(spec.environment.drag_normal == 8);
    BOOST_TEST(spec.environment.drag_tangential == 4);
    BOOST_TEST(!spec.environment.has_ground);
    BOOST_TEST(spec.actuation_range == Parameters{}.water.actuation_range_aquatic);
    BOOST_TEST(spec.parameters.neat.population == Parameters{}.neat.population);
}

BOOST_AUTO_TEST_CASE(a_choice_is_stated_by_its_name_and_read_back_as_one) {
    const char *text = "return paper.experiment { name = 'x', parameters = { division_turn = 'daughter', "
                       "gait_time = planula.parameters.gait_time } }";
    const Parameters p = experiment(text).settings[0].parameters;
    BOOST_TEST((p.development.division_turn == DivisionTurn::daughter));
    BOOST_TEST((p.gait.gait_time == Parameters{}.gait.gait_time));
}

BOOST_AUTO_TEST_CASE(a_change_of_one_drag_keeps_the_other) {
    const World world = environment_of("paper.aquatic { drag = { normal = 3 } }");
    BOOST_TEST(world.environment.drag_normal == 3);
    BOOST_TEST(world.environment.drag_tangential == Parameters{}.water.drag_tangential);
}

BOOST_AUTO_TEST_CASE(a_changed_parameter_changes_the_world_that_names_it) {
    const char *text = "return paper.experiment { name = 'x', environment = paper.terrestrial(), parameters "
                       "= { gravity = 2 } }";
    BOOST_TEST(experiment(text).settings[0].environment.gravity == 2);
    BOOST_TEST(experiment(text, {{"gravity", 3}}).settings[0].environment.gravity == 3);
    BOOST_TEST(experiment(text).settings[0].environment.friction == Parameters{}.land.friction);
}

BOOST_AUTO_TEST_CASE(grounds_are_flat_none_points_or_a_function) {
    BOOST_TEST(environment_of("paper.terrestrial()").environment.has_ground);
    BOOST_TEST(environment_of("paper.terrestrial()").environment.ground.empty());
    BOOST_TEST(!environment_of("paper.terrestrial { ground = 'none', gravity = 0 }").environment.has_ground);
    const auto points =
        environment_of("paper.terrestrial { ground = { { -1, 2 }, { 1, 3 } } }").environment.ground;
    BOOST_REQUIRE_EQUAL(points.size(), 2u);
    BOOST_TEST((points[1] == Vec2d{1, 3}));
    const auto sampled =
        environment_of("paper.terrestrial { ground = { height = function(x) return x * x end, "
                       "from = -1, to = 1, step = 0.5 } }")
            .environment.ground;
    BOOST_REQUIRE_EQUAL(sampled.size(), 5u);
    BOOST_TEST((sampled[0] == Vec2d{-1, 1}));
    BOOST_TEST((sampled[3] == Vec2d{0.5, 0.25}));
}

BOOST_AUTO_TEST_CASE(a_ground_function_is_called_from_end_to_end_only) {
    const auto places = [](const std::string &range) {
        std::vector<double> xs;
        for (const Vec2d point :
             environment_of("paper.terrestrial { ground = { height = function(x) return math.sqrt("
                            "100 - x * x) end, " +
                            range + " } }")
                 .environment.ground)
            xs.push_back(point.x);
        return xs;
    };
    BOOST_TEST(places("from = -1, to = 1, step = 0.75") == (std::vector<double>{-1, -0.25, 0.5, 1}));
    BOOST_TEST(places("from = -10, to = 10, step = 15") == (std::vector<double>{-10, 5, 10}));
    BOOST_TEST(places("from = -10, to = 10, step = 50") == (std::vector<double>{-10, 10}));
    BOOST_TEST(places("from = -10, to = 10, step = 0.75").back() == 10);
    // Steps whose sum differs from the end by rounding.
    for (const int points : {4, 11, 50, 1000, 3000}) {
        const auto xs = places("from = -1, to = 1, step = 2 / " + std::to_string(points - 1));
        BOOST_TEST(xs.size() == static_cast<std::size_t>(points));
        BOOST_TEST(xs.back() == 1);
        BOOST_TEST(xs[xs.size() - 2] < 1 - 1.9 / points);
    }
}

BOOST_AUTO_TEST_CASE(obstacles_ceilings_patches_and_objects_are_read) {
    const Environment world =
        environment_of("paper.terrestrial { obstacles = { { { 5, 0 }, { 7, 0 }, { 6, 3 } }, "
                       "{ points = { { -9, 0 }, { -7, 0 }, { -8, 2 } }, friction = "
                       "'friction' } }, ceiling = { height = function(x) return 9 + x * x end, "
                       "from = -1, to = 1, step = 1 }, friction_patches = { { from = -3, "
                       "to = 2, friction = 0.1 } }, object = { at = { -4, 2 }, radius = 1 } }")
            .environment;
    BOOST_TEST_REQUIRE(world.obstacles.size() == 2u);
    BOOST_TEST(!world.obstacles[0].friction);
    BOOST_TEST((world.obstacles[0].points[2] == Vec2d{6, 3}));
    BOOST_TEST(world.obstacles[1].friction.value() == 0.8);
    BOOST_TEST((world.ceiling == std::vector<Vec2d>{{-1, 10}, {0, 9}, {1, 10}}));
    BOOST_TEST(world.friction_patches.at(0).to == 2);
    BOOST_TEST(world.object.cells() == 7);
    const Environment shaped =
        environment_of(
            "paper.terrestrial { object = { at = { 5, 1 }, shape = { { 0, 0 }, { 3, 0 }, { 3, 1 }, "
            "{ 0, 1 } } } }")
            .environment;
    BOOST_TEST(shaped.object.cells() == 7);
}

BOOST_AUTO_TEST_CASE(a_bad_obstacle_is_refused_on_its_line) {
    const auto refused_with = [](const std::string &key, const std::string &message) {
        const std::string found = refused_body("environment = paper.terrestrial {\n" + key + " }");
        BOOST_TEST(test::contains(found, message), found);
        BOOST_TEST(test::contains(found, "test.lua:"), found);
    };
    refused_with("obstacles = { { 5, 0 }, { 6, 0 }, { 6, 2 } }",
                 "a point of environment.obstacles[1] is {x, y}");
    refused_with("obstacles = { points = { } }",
                 "test.lua:4: environment.obstacles must be a list of polygons");
    refused_with("obstacles = { { points = { { 5, 0 } }, frictoin = 1 } }", "did you mean 'friction'?");
    refused_with("obstacles = { { { 5, 0 }, { 6, 0 } } }", "obstacle 1 needs three points or more, not 2");
    refused_with("obstacles = { { { 5, 0 }, { 7, 2 }, { 7, 0 }, { 5, 2 } } }", "its sides 1 and 3 do");
    refused_with("obstacles = { { { -1, 0 }, { 1, 0 }, { 0, 2 } } }",
                 "must leave the place free where bodies start");
    refused_with("ceiling = { { -1, 2 }, { 1, 0.5 } }",
                 "the ceiling must be a cell or more above the ground");
    refused_with("ceiling = 3", "environment.ceiling must be a table");
    refused_with("friction_patches = { { from = 1, to = 0, friction = 1 } }", "from < to");
    refused_with(
        "friction_patches = { { from = 0, to = 2, friction = 1 }, { from = 1, to = 3, friction = 1 } }",
        "friction patches must ascend and not overlap");
    refused_with("object = { at = { 5, 2 } }", "environment.object needs a shape");
    refused_with("object = { at = { 5, 2 }, radius = 0.5 }", "an object needs 3 … 500 cells");
    refused_with("object = { at = { 5, 0 }, radius = 1 }", "above the ground by 0.1 or more");
}

BOOST_AUTO_TEST_CASE(a_bad_ground_is_refused_on_its_line) {
    const auto ground = [](const std::string &value) {
        return refused_body("environment = paper.terrestrial {\nground = " + value + " }");
    };
    BOOST_TEST(test::contains(ground("'hilly'"), "test.lua:4: environment.ground must be \"flat\""));
    BOOST_TEST(
        test::contains(ground("{ { 0, 0 }, { 1 } }"), "test.lua:4: a point of environment.ground is {x, y}"));
    BOOST_TEST(test::contains(ground("{ { 0, 0 } }"), "two points or more"));
    BOOST_TEST(test::contains(ground("{ { 1, 0 }, { 0, 0 } }"), "ascend"));
    BOOST_TEST(test::contains(ground("{ height = function(x) return nil end, from = 0, to = 1, step = 1 }"),
                              "environment.ground.height(0) must return a finite number"));
    BOOST_TEST(test::contains(ground("{ height = function(x) return y.z end, from = 0, to = 1, step = 1 }"),
                              "test.lua:4: nothing is called 'y'"));
    BOOST_TEST(test::contains(ground("{ height = function(x) return x end, from = 0, to = 1, step = 0 }"),
                              "from, to and step"));
    for (const char *range :
         {"from = 1, to = 1, step = 1", "from = 1, to = 0, step = 1", "from = 0, to = 1, step = -1",
          "from = 0, to = 1, step = 1e-5", "from = -1e300, to = 1e300, step = 1e-300"})
        BOOST_TEST(test::contains(ground("{ height = function(x) return x end, " + std::string(range) + " }"),
                                  "must give 2 … 100000 points"),
                   range);
    // Upright and overhanging walls are no heights over x.
    BOOST_TEST(test::contains(ground("{ { 0, 0 }, { 0, 1 } }"),
                              "test.lua:3: environment: ground points must ascend"));
    BOOST_TEST(test::contains(ground("{ { 0, 0 }, { 2, 1 }, { 1, 2 } }"), "must ascend in x, not 1"));
    BOOST_TEST(
        test::contains(ground("{ height = function(x) return x end, from = 0, to = 1 }"), "step is missing"));
}

BOOST_AUTO_TEST_CASE(unknown_keys_are_reported_with_line_owner_and_nearest_name) {
    BOOST_TEST(test::contains(
        refused_body("serach = 'neat'"),
        "test.lua:3: the experiment has no 'serach'; did you mean 'search'? (allowed: name, "));
    BOOST_TEST(test::contains(refused_body("environment = paper.aquatic {\n drag = {\n  nromal = 8 } }"),
                              "test.lua:5: environment.drag has no 'nromal'; did you mean 'normal'?"));
    BOOST_TEST(test::contains(
        refused_body("parameters = {\n spring_stifness = 5 }"),
        "test.lua:4: no parameter is called 'spring_stifness'; did you mean 'spring_stiffness'?"));
    BOOST_TEST(test::contains(refused_body("search = 'novelti'"),
                              "test.lua:3: search: 'novelti' is not one of neat, novelty, nsga2, nslc, "
                              "map-elites; did you mean 'novelty'?"));
    BOOST_TEST(test::contains(refused_body("actuation = 'gnn'"), "did you mean 'grn'?"));
    BOOST_TEST(test::contains(refused_body("5"), "test.lua:3: the experiment has a value without a name"));
}

BOOST_AUTO_TEST_CASE(wrong_kinds_and_ranges_are_reported_with_the_rule) {
    BOOST_TEST(test::contains(refused_body("title = 5"), "test.lua:3: title must be a text, not a number"));
    BOOST_TEST(test::contains(refused_body("fitness = 'far'"),
                              "test.lua:3: fitness must be a function, not a text"));
    BOOST_TEST(test::contains(refused_body("parameters = { population = 1 }"),
                              "test.lua:3: population = 1 is outside 2"));
    BOOST_TEST(test::contains(refused_body("parameters = { seeds = 1.5 }"), "must be a whole number"));
    BOOST_TEST(test::contains(refused_body("parameters = { seeds = 'x' }"),
                              "parameters.seeds must be a number, not a text"));
    BOOST_TEST(test::contains(refused_body("parameters = { division_turn = 2 }"),
                              "test.lua:3: parameters.division_turn must be a text, not a number"));
    BOOST_TEST(test::contains(refused_body("parameters = { division_turn = 'non' }"),
                              "division_turn = non must be one of 'nobody', 'daughter', 'both'"));
    BOOST_TEST(test::contains(refused_body("environment = paper.aquatic { drag = { normal = 'gait_time' } }"),
                              "gait_time is a choice, not a number"));
    BOOST_TEST(test::contains(refused_body("environment = paper.aquatic { gravity = 5 }"),
                              "gravity without ground"));
    BOOST_TEST(test::contains(refused_body("environment = paper.aquatic { drag = { normal = -1 } }"),
                              "0 or more, not -1"));
    BOOST_TEST(test::contains(refused_body("environment = paper.aquatic { actuation_range = 2 }"), "not 2"));
    BOOST_TEST(
        test::contains(refused_body("environment = paper.aquatic { actuation_range = 0/0 }"), "finite"));
    BOOST_TEST(
        test::contains(refused_body("parameters = { period_shortest = 500 }"), "period_shortest is at most"));
    BOOST_TEST(test::contains(refused("return paper.experiment { name = '../x' }"), "'../x'"));
    BOOST_TEST(test::contains(refused("return planula.experiment { name = 'x' }"), "environment is missing"));
}

BOOST_AUTO_TEST_CASE(all_errors_are_reported_together) {
    const std::string message =
        refused_body("serach = 'neat',\nparameters = { sedes = 1,\npopulation = 0 },\ntitel = 'x'");
    for (const char *part : {"test.lua:3: ", "test.lua:4: ", "test.lua:5: ", "test.lua:6: "})
        BOOST_TEST(test::contains(message, part), message);
}

BOOST_AUTO_TEST_CASE(an_error_in_one_setting_of_a_design_is_reported_once_with_its_line) {
    const std::string message = refused("local water = paper.aquatic {\n" // 2
                                        "  drga = { normal = 1 } }\n"     // 3
                                        "return paper.design { name = 'x', settings = {\n"
                                        "  { name = 'a', environment = water },\n"
                                        "  { name = 'b', environment = water, search = 'neat' },\n"
                                        "  { name = 'c', search = 'naet' },\n" // 7
                                        "  { name = 'c' },\n"                  // 8
                                        "} }");
    BOOST_TEST(message.find("drga") == message.rfind("drga"), message);
    BOOST_TEST(test::contains(message, "test.lua:7: settings[3].search: 'naet' is not one of"), message);
    BOOST_TEST(test::contains(message, "test.lua:8: two settings are called 'c'"), message);
    BOOST_TEST(test::contains(message, "test.lua:3: environment has no 'drga'; did you mean 'drag'?"),
               message);
}

BOOST_AUTO_TEST_CASE(the_name_of_an_experiment_must_be_a_file_name) {
    for (const std::string name : {"../../../escaped", "a/b", "", "a b", "."}) {
        const std::string message =
            refused("return paper.design {\nname = '" + name + "', settings = { { name = 'a' } } }");
        BOOST_TEST(message ==
                   "test.lua:3: the name of an experiment is 1 to 100 letters, digits, '-' and '_', not '" +
                       name + "'");
        BOOST_TEST(test::contains(refused("return paper.experiment {\nname = '" + name + "' }"),
                                  "test.lua:2: the name of a setting is 1 to 100 letters"));
    }
    BOOST_TEST(refused("return paper.design { name = 'A-b_9', settings = { { name = 'a' } } }") == "");
}

BOOST_AUTO_TEST_CASE(every_text_must_be_one_line) {
    BOOST_TEST(refused("return paper.experiment { name = 'x',\n title = [[Thick water,\nas in honey]] }") ==
               "test.lua:3: title must be one line, without a line break or a zero byte");
    for (const char *text : {"a\\nb", "a\\r", "\\0", "a\\0b"}) {
        BOOST_TEST(test::contains(
                       refused("return paper.design { name = 'x', settings = {\n{ name = 'a',\ntitle = '" +
                               std::string(text) + "' } } }"),
                       "test.lua:4: settings[1].title must be one line"),
                   text);
        BOOST_TEST(test::contains(refused("return paper.design { name = 'x', settings = { { name = 'a' } },\n"
                                          "statistics = planula.fill({ claims = { { id = 'C', a = 'a', judge "
                                          "= function() end,\nstatement = '" +
                                          std::string(text) + "' } } }, require 'paper.summary') }"),
                                  "test.lua:4: statistics.claims[1].statement must be one line"));
    }
}

BOOST_AUTO_TEST_CASE(parameters_of_a_design_hold_for_all_settings_and_each_may_change_them) {
    const Experiment e =
        experiment("return paper.design { name = 'x', parameters = { seeds = 3, population = 10 },\n"
                   "settings = { { name = 'a' }, { name = 'b', parameters = { population = 12 } } } }",
                   {{"generations", 7}});
    BOOST_TEST(e.settings[0].parameters.neat.population == 10);
    BOOST_TEST(e.settings[1].parameters.neat.population == 12);
    BOOST_TEST(e.settings[1].parameters.design.seeds == 3);
    BOOST_TEST(e.settings[1].parameters.design.generations == 7);
    BOOST_TEST(e.analysis.design.design.generations == Parameters{}.design.generations);
}

BOOST_AUTO_TEST_CASE(how_much_a_run_records_is_stated_for_all_settings_or_for_one) {
    const auto recordings = [](const std::string &text) {
        std::string names;
        for (const Spec &spec : experiment(text).settings) names += name_of(spec.record) + " ";
        return names;
    };
    BOOST_TEST(recordings("return paper.experiment { name = 'x' }") == "full ");
    BOOST_TEST(recordings("return paper.experiment { name = 'x', record = 'sample' }") == "sample ");
    BOOST_TEST(recordings("return paper.design { name = 'x', record = 'sample',\n"
                          "settings = { { name = 'a' }, { name = 'b', record = 'full' } } }") ==
               "sample full ");
    BOOST_TEST(recordings("return paper.design { name = 'x', record = 300,\n"
                          "settings = { { name = 'a' }, { name = 'b', record = 1000 } } }") ==
               "sample of 300 sample ");
    BOOST_TEST(test::contains(refused_body("record = 0"), "test.lua:3: record: a sample has 1 to "));
    BOOST_TEST(
        test::contains(refused_body("record = 'sampel'"),
                       "test.lua:3: record: 'sampel' is not one of full, sample; did you mean 'sample'?"));
    BOOST_TEST(test::contains(refused_body("record = true"), "test.lua:3: record must be a text"));
}

BOOST_AUTO_TEST_CASE(only_overrides_that_decide_lives_are_kept_with_a_run) {
    const Experiment e =
        experiment("return paper.experiment { name = 'x' }",
                   {{"generations", 7}, {"drag_normal", 2}, {"confidence", 0.9}, {"seeds", 3}});
    const RunSources sources = sources_of(e);
    BOOST_REQUIRE_EQUAL(sources.overrides.size(), 1u);
    BOOST_TEST(sources.overrides[0].first == "drag_normal");
    std::vector<std::string> files;
    for (const RunSources::File &file : sources.files) files.push_back(file.path);
    BOOST_TEST(files.front() == "experiment.lua");
    BOOST_TEST((std::find(files.begin(), files.end(), "paper.lua") != files.end()));
    BOOST_TEST((std::find(files.begin(), files.end(), "paper/judgement.lua") != files.end()));
}

BOOST_AUTO_TEST_CASE(claims_and_tables_are_checked_on_their_line) {
    // `fields` begins on line 5.
    const auto statistics = [](const std::string &fields) {
        return refused("return paper.design { name = 'x', settings = { { name = 'a' }, { name = 'b' } },\n"
                       "statistics = { confidence = 0.95, resamples = 100, significance = 0.05, sample_share "
                       "= 0.01, sample_least = 10,\n\n" +
                       fields + "\n} }");
    };
    const auto claims = [&](const std::string &claim) { return statistics("claims = {\n" + claim + "\n}"); };
    const std::string good =
        "id = 'S1', statement = 's', a = 'a', "
        "judge = function(runs) return { verdict = 'inconclusive', effect = runs.a.best_fitness[1][1] } end";
    BOOST_TEST(claims("{ " + good + " }") == "");
    BOOST_TEST(claims("{ " + good +
                      ", b = 'b', test = 'mine', section = '1', paper = 'p', generation = 3, "
                      "calibrated = true }") == "");
    const auto says = [](const std::string &said, const std::string &words) {
        BOOST_TEST(test::contains(said, words), said);
    };
    says(claims("{ " + good + ", b = 'bb' }"), "test.lua:6: claim 'S1': there is no setting 'bb'");
    says(claims("{ " + good + ", expect = 'greater' }"), "test.lua:6: statistics.claims[1] has no 'expect'");
    says(claims("{ " + good + ", calibrate = true }"), "did you mean 'calibrated'?");
    says(claims("{ " + good + ", calibrated = 1 }"), "calibrated must be true or false");
    says(claims("{ " + good + ", generation = 1.5 }"), "generation = 1.5 must be a whole number");
    says(claims("{ " + good + " }, { " + good + " }"), "two claims are called 'S1'");
    says(claims("{ id = 'S1', a = 'a' }"), "statement is missing");
    says(claims("{ id = 'S1', statement = 's', a = 'a' }"), "judge is missing");
    says(claims("{ id = 'S1', statement = 's', a = 'a', judge = 'best' }"),
         "judge must be a function, not a text");
    says(claims("{ id = 'S1', statement = 's', a = 'a',\njudge = function(runs) return runs.c end }"),
         "test.lua:7: runs has no 'c'");
    says(statistics("tables = {\nmine = 3 }"),
         "test.lua:6: statistics.tables.mine must be a function, not a number");
    says(statistics("tables = { function() end }"), "tables are stated by name");
    says(statistics("tables = {\nruns = function() end }"), "test.lua:6: planula writes runs.csv itself");
    says(statistics("tables = {\n['../x'] = function() end }"), "the name of a table is 1 to 100 letters");
    says(statistics("tables = {\nmine = function() return 3 end }"),
         "test.lua:6: the table 'mine' returned number");
    BOOST_TEST(statistics("tables = { mine = function(runs) return { { x = #runs.a } } end }") == "");
    says(refused_body("statistics = 'paper.statistic'"), "test.lua:3: no module 'paper.statistic'");
}

BOOST_AUTO_TEST_CASE(the_settings_of_a_recorded_run_are_read_without_its_statistics) {
    const auto sources = [] {
        return test::script(
            "local paper = require 'paper'\nreturn paper.experiment { name = 'x', statistics = { claims = "
            "{ { test = 'of earlier versions' } } } }");
    };
    BOOST_TEST(load_experiment(sources(), {}, Part::settings).settings.size() == 1u);
    BOOST_TEST(test::refusal([&] { load_experiment(sources()); }) != "");
}

BOOST_AUTO_TEST_CASE(every_search_is_one_line) {
    for (const std::string search : {"neat", "novelty", "nsga2", "nslc", "map-elites"})
        BOOST_TEST(experiment("return paper.experiment { name = 'x', search = '" + search + "' }")
                       .settings[0]
                       .search == search);
}

BOOST_AUTO_TEST_CASE(a_start_is_generations_and_the_behaviour_of_bodies) {
    BOOST_TEST(!experiment("return paper.experiment { name = 'x' }").settings[0].start.has_value());
    const Experiment e =
        experiment("return paper.experiment { name = 'x', start = { generations = 7, behaviour = "
                   "function(life, parameters) return { life.cells, parameters.cell_limit } end } }");
    const Spec &spec = e.settings[0];
    BOOST_REQUIRE(spec.start.has_value());
    BOOST_TEST(spec.start->generations == 7);
    Life grown;
    grown.outcome = Outcome::viable;
    grown.cells = 20;
    BOOST_TEST((spec.start->judge(grown) == Evaluation{0, {20, 256}, 1}));
    BOOST_TEST((spec.judge(grown).behaviour == std::vector<double>{0, 0})); // the run's own is the paper's
    grown.outcome = Outcome::too_small;
    BOOST_TEST(!spec.start->judge(grown).valid());
}

BOOST_AUTO_TEST_CASE(a_bad_start_is_refused_on_its_line) {
    const std::string behaviour = "behaviour = function(life) return { life.cells } end";
    const auto start = [&](const std::string &fields) { return refused_body("start = { " + fields + " }"); };
    BOOST_TEST(test::contains(start(behaviour), "start.generations is missing"));
    BOOST_TEST(test::contains(start("generations = -1, " + behaviour), "must be a whole number"));
    BOOST_TEST(test::contains(start("generations = 2"), "behaviour is missing"));
    BOOST_TEST(test::contains(start("generation = 2, " + behaviour), "did you mean 'generations'?"));
}

BOOST_AUTO_TEST_CASE(objectives_and_descriptor_are_stated_as_lists) {
    const Experiment e = experiment(
        "return paper.experiment { name = 'x', search = 'nsga2', objectives = {\n"
        "{ name = 'distance', value = function(life) return life.displacement end, goal = 'maximise' },\n"
        "{ name = 'work', value = function(life) return life.work end, goal = 'minimise' }, 'novelty' },\n"
        "descriptor = { { name = 'x', from = -10, to = 10, cells = 5 }, { name = 'y', from = 0, to = 1, "
        "cells = 2 } } }");
    const Spec &spec = e.settings[0];
    BOOST_REQUIRE(spec.aims.objectives.size() == 3u);
    BOOST_TEST(spec.aims.objectives[1].name == "work");
    BOOST_TEST((spec.aims.objectives[1].goal == Objective::Goal::minimise));
    BOOST_TEST((spec.aims.objectives[2].value == Objective::Value::novelty));
    BOOST_TEST((spec.aims.descriptor[0].from == -10 && spec.aims.descriptor[0].cells == 5));
    BOOST_TEST(spec.observed.has(Observation::work));
    BOOST_TEST(spec.judgement.back().name == "objective work");
    BOOST_TEST(spec.judgement.back().place == "test.lua:4");
}

BOOST_AUTO_TEST_CASE(bad_objectives_are_refused_on_their_lines) {
    const std::string far = "name = 'far', value = function(life) return life.displacement end";
    const auto refused_list = [&](const std::string &list, const std::string &search = "nsga2") {
        return refused_body("search = '" + search + "', objectives =\n{ " + list + " }");
    };
    const auto says = [&](const std::string &list, const std::string &message) {
        BOOST_TEST(test::contains(refused_list(list), message), refused_list(list));
    };
    says("{ " + far + ", goal = 'maximize' }",
         "test.lua:4: objectives[1].goal: 'maximize' is not one of maximise, minimise");
    says("{ " + far + " }", "objectives[1].goal is missing");
    says("{ name = 'far', goal = 'maximise' }", "objectives[1].value is missing");
    says("{ name = 'far', goal = 'maximise', value = 7 }", "objectives[1].value must be a function");
    says("{ " + far + ", goal = 'maximise', aim = 1 }", "objectives[1] has no 'aim'");
    says("'novelti'", "'novelti' is not one of fitness, novelty; did you mean 'novelty'?");
    says("7", "objectives[1] must be a table { name =, value =, goal = }, \"fitness\" or \"novelty\", not a "
              "number");
    says("", "objectives is empty");
    says("{ " + far + ", goal = 'maximise' }, { " + far + ", goal = 'minimise' }",
         "two of the names are 'far'");
    says("{ name = '2 far', value = function() return 1 end, goal = 'maximise' }",
         "the name of an objective");
    BOOST_TEST(test::contains(refused_list("{ " + far + ", goal = 'maximise' }", "neat"),
                              "search 'neat' reads no objectives, but fitness; nsga2 and nslc read them"));
}

BOOST_AUTO_TEST_CASE(bad_descriptors_are_refused_on_their_lines) {
    const auto says = [&](const std::string &list, const std::string &message) {
        const std::string text = refused_body("search = 'map-elites', descriptor =\n{ " + list + " }");
        BOOST_TEST(test::contains(text, message), text);
    };
    says("{ name = 'x', from = 0, to = 1 }, { name = 'y' }",
         "test.lua:4: descriptor[1]: from, to and cells go together");
    says("{ name = 'x', from = 1, to = 1, cells = 3 }, { name = 'y', from = 0, to = 1, cells = 1 }",
         "descriptor x: from must be below to, not 1 and 1");
    says("{ name = 'x', from = 0, to = 1, cells = 0 }, { name = 'y' }", "cells is 1 to 10000");
    says("{ name = 'x', from = 0, to = 1, cells = 20000 }, { name = 'y', from = 0, to = 1, cells = 1 }",
         "cells is 1 to 10000, not 20000");
    says("{ name = 'x', from = 0, to = 1, cells = 2 }, { name = 'y' }",
         "for every number of the descriptor, or for none");
    says("'x'", "descriptor[1] must be a table");
}

BOOST_AUTO_TEST_CASE(a_setting_observes_what_its_functions_name) {
    const auto observed = [](const std::string &fitness, const std::string &before = "") {
        return experiment(before + "\nreturn paper.experiment { name = 'x', fitness = " + fitness + " }")
            .settings[0]
            .observed;
    };
    ObservationSet work;
    work.add(Observation::work);
    BOOST_TEST((observed("paper.judgement.fitness").empty()));
    BOOST_TEST((observed("function(life) return life.work end") == work));
    BOOST_TEST((observed("function(life) return life['work'] end") == work));
    BOOST_TEST((observed("function(life) return cost(life) end",
                         "local function cost(life) return life.work end") == work));
    BOOST_TEST((observed("function(life) local work = 1 return work end").empty()));
}

BOOST_AUTO_TEST_CASE(activity_is_refused_with_oscillators_unless_eq_4_weights_it) {
    const std::string read = "fitness = function(life) return life.activity end";
    BOOST_TEST(test::contains(refused_body(read), "test.lua:3: fitness reads life.activity, which is 0 with "
                                                  "oscillators"),
               refused_body(read));
    BOOST_TEST(test::contains(refused_body(read), "life.work"));
    BOOST_TEST(refused_body(read + ", actuation = 'grn'") == "");
    BOOST_TEST(refused_body("fitness = paper.judgement.fitness") == "");
}

BOOST_AUTO_TEST_CASE(a_start_that_reads_what_only_moving_bodies_have_is_refused_on_its_line) {
    const auto start = [](const std::string &result) {
        return refused_body("start = { generations = 2, behaviour = function(life)\nreturn " + result +
                            " end }");
    };
    for (const std::string field :
         {"activity", "displacement", "finish", "late_actuation", "path", "rest", "settle_steps"})
        BOOST_TEST(
            test::contains(start("{ life." + field + " and 1 }"),
                           "test.lua:4: life." + field +
                               " is known only after a body has moved; a start judges by growth alone"),
            start("{ life." + field + " and 1 }"));
    BOOST_TEST(
        test::contains(refused_body("start = { generations = 2, behaviour = paper.judgement.behaviour }"),
                       "life.finish is known only"));
    // The penalty function is called for grown bodies, too.
    BOOST_TEST(test::contains(
        refused_body("start = { generations = 2, behaviour = function(life) return { life.cells } end },\n"
                     "penalty = function(life) return life.settle_steps > 0 and 1 or 0 end"),
        "test.lua:4: life.settle_steps is known only"));
    const std::string known =
        "{ life.births, life.cells, life.elongation, life.largest, life.springs, life.triangles, "
        "life.outcome == 'viable' and 1 or 0 }";
    BOOST_TEST(experiment("return paper.experiment { name = 'x', start = { generations = 2, behaviour = "
                          "function(life) return " +
                          known + " end } }")
                   .settings.size() == 1);
}

BOOST_AUTO_TEST_CASE(descriptors_have_the_stated_values) {
    const auto described = [](const std::string &name, const Life &life) {
        const Experiment e =
            experiment("return paper.experiment { name = 'x', search = 'map-elites', behaviour "
                       "= require('descriptors')." +
                       name + " }");
        return e.settings[0].judge(life).behaviour;
    };
    Life life;
    life.outcome = Outcome::viable;
    life.cells = 40, life.springs = 90, life.elongation = 3;
    // Sixteenths of a turn: right, up, left, down, and a hair below right.
    for (const auto &[moved, sixteenth] : {std::pair{Vec2d{2, 0}, 0.0},
                                           {Vec2d{0, 3}, 4.0},
                                           {Vec2d{-1, 0}, 8.0},
                                           {Vec2d{0, -1}, 12.0},
                                           {Vec2d{1, -1e-300}, 0.0}}) {
        life.finish = moved;
        BOOST_TEST((described("size_and_direction", life) == std::vector<double>{2.5, sixteenth}));
    }
    life.rest = {1, 1}, life.finish = {1, 3};
    BOOST_TEST((described("size_and_direction", life) == std::vector<double>{2.5, 4}));
    BOOST_TEST((described("shape", life) == std::vector<double>{2.5, 3, 9}));
    life.elongation = 0; // no width at all
    BOOST_TEST((described("shape", life) == std::vector<double>{2.5, 8, 9}));
}

BOOST_AUTO_TEST_CASE(every_experiment_file_passes_its_check) {
    for (const auto &file : test::experiment_files()) {
        Experiment e;
        BOOST_TEST(test::refusal([&] { e = load_experiment(file, test::experiments_folder()); }) == "",
                   file.string());
        BOOST_TEST(!e.settings.empty(), file.string());
        BOOST_TEST(!e.title.empty(), file.string());
    }
}

BOOST_AUTO_TEST_CASE(the_first_reading_is_the_standard_one_and_no_other_is) {
    const Experiment e =
        load_experiment(test::experiments_folder() / "readings.lua", test::experiments_folder());
    for (const Spec &spec : e.settings) {
        bool differs = false;
        for (const ParameterRow &row : parameter_rows())
            if (row.name != "seeds" && row.name != "generations")
                differs = differs || parameter(spec.parameters, row.name) != row.standard;
        BOOST_TEST(differs != spec.name.starts_with("standard-"), spec.name);
    }
}

BOOST_AUTO_TEST_CASE(the_replication_states_the_papers_eight_settings) {
    const Experiment e =
        load_experiment(test::experiments_folder() / "paper" / "replication.lua", test::experiments_folder());
    BOOST_REQUIRE_EQUAL(e.settings.size(), 8u);
    for (const Spec &spec : e.settings) {
        const bool osc = spec.name.starts_with("osc"), water = test::contains(spec.name, "-aq-");
        const bool novelty = spec.name.ends_with("-ns");
        BOOST_TEST((spec.actuation == (osc ? Actuation::oscillator : Actuation::grn)), spec.name);
        BOOST_TEST(spec.search == (novelty ? "novelty" : "neat"), spec.name);
        BOOST_TEST(spec.environment.has_ground == !water, spec.name);
        BOOST_TEST(spec.environment.has_fluid() == water, spec.name);
        BOOST_TEST(spec.environment.gravity == (water ? 0 : Parameters{}.land.gravity), spec.name);
        BOOST_TEST(spec.actuation_range == (water ? 0.4 : 0.3), spec.name);
        for (const ParameterRow &row : parameter_rows())
            BOOST_TEST(parameter(spec.parameters, row.name) == row.standard, row.name);
    }
    // S1 to S13, each with at least one test.
    for (int i = 1; i <= 13; ++i) {
        bool found = false;
        for (const Claim &claim : e.analysis.claims)
            found = found || std::string_view(claim.id).substr(0, claim.id.find_first_of("abcdefgh")) ==
                                 "S" + std::to_string(i);
        BOOST_TEST(found, "S" << i);
    }
}
