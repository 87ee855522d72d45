// SPDX-License-Identifier: MIT
#include "statement/judging_functions.h"

#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

// The paper's experiment with one function of its own; `before` stands above the statement.
std::shared_ptr<Sources> with(const std::string &function, const std::string &before = "") {
    return test::script("local paper = require 'paper'\n" + before +
                        "\nreturn paper.experiment { name = 'x',\n" + function + "\n}");
}

Life life_at(double x) {
    Life life;
    life.outcome = Outcome::viable;
    life.cells = 10;
    life.finish = {x, 0};
    life.path = {{0, 0}, {x / 2, 1}, {x, 0}};
    return life;
}

double fitness_of(const std::string &expression) {
    JudgingFunctions functions(
        with("fitness = function(life, parameters, penalty) return " + expression + " end"), 0, {});
    const double fitness = functions.judge(life_at(8)).fitness;
    BOOST_TEST(functions.invalid() == 0, functions.first_problem());
    return fitness;
}

std::string trial(const std::string &function, const std::string &before = "") {
    return test::refusal([&] { JudgingFunctions(with(function, before), 0, {}).try_out(); });
}

} // namespace

BOOST_AUTO_TEST_CASE(a_function_sees_the_whole_life) {
    BOOST_TEST(fitness_of("life.displacement") == 8);
    BOOST_TEST(fitness_of("life.finish.x - life.rest.x + life.finish.y + life.cells") == 18);
    BOOST_TEST(fitness_of("#life.path * 100 + life.path[2].x * 10 + life.path[2].y") == 341);
    BOOST_TEST(
        fitness_of("life.path[4] == nil and life.path[0] == nil and life.path[1.5] == nil and 1 or 0") == 1);
    BOOST_TEST(
        fitness_of(
            "(function() local n = 0 for i, p in ipairs(life.path) do n = n + i * p.x end return n end)()") ==
        2 * 4 + 3 * 8);
    BOOST_TEST(fitness_of("life.outcome == 'viable' and 1 or 0") == 1);
    BOOST_TEST(fitness_of("life.births + life.largest + life.springs + life.triangles + life.elongation + "
                          "life.settle_steps + life.activity + life.late_actuation") == 0);
}

BOOST_AUTO_TEST_CASE(a_function_sees_what_a_life_was_asked_for) {
    Life life = life_at(8);
    life.observations.known.add(Observation::work);
    life.observations.known.add(Observation::signals);
    life.observations.known.add(Observation::gait_phases);
    life.observations.work = 3;
    life.observations.signals = {{1, 2}, {3, 4}, {5, 6}};
    life.observations.gait_phases = {0, 0.25};
    JudgingFunctions functions(
        with("fitness = function(life) local s = life.signals\n"
             "return life.work + 10 * #s + 100 * s[3][2] + 1000 * life.gait_phases[2] + "
             "(s[4] == nil and s[1][3] == nil and #s[2] or 0) end"),
        0, {});
    BOOST_TEST(functions.judge(life).fitness == 3 + 30 + 600 + 250 + 2);
    BOOST_TEST(functions.invalid() == 0, functions.first_problem());
}

BOOST_AUTO_TEST_CASE(what_a_life_was_not_asked_for_cannot_be_read) {
    JudgingFunctions functions(with("fitness = function(life) return life['wo' .. 'rk'] end"), 0, {});
    BOOST_TEST(!functions.judge(life_at(8)).valid());
    BOOST_TEST(
        test::contains(functions.first_problem(),
                       "test.lua:4: life.work is computed only for functions that name it: write life.work"),
        functions.first_problem());
    BOOST_TEST(test::contains(trial("fitness = function(life) return life.wrk end"), "did you mean 'work'?"));
    BOOST_TEST(test::contains(trial("fitness = function(life) return life.signals.x end"), "life has no") ==
               false);
}

BOOST_AUTO_TEST_CASE(objectives_are_judged_in_their_order_and_may_be_negative) {
    const std::string rest =
        "behaviour = function(life) return { life.cells } end, search = 'nsga2', objectives = {\n"
        "{ name = 'left', goal = 'maximise', value = function(life) return -life.finish.x end },\n"
        "'fitness',\n"
        "{ name = 'odd', goal = 'minimise', value = function(life, p, penalty)\n"
        "if life.finish.x > 5 then return 0/0 end return penalty end } }";
    JudgingFunctions functions(with(rest), 0, {});
    BOOST_TEST((functions.judge(life_at(3)).objectives == std::vector<double>{-3, 1}));
    BOOST_TEST((functions.judge(life_at(8)) == Evaluation{}));
    BOOST_TEST(functions.invalid() == 1);
    BOOST_TEST(test::contains(functions.first_problem(), "test.lua:7: objective odd returned "),
               functions.first_problem());
    BOOST_TEST(
        test::contains(trial("search = 'nsga2', objectives = { { name = 'odd', goal = 'minimise', value = "
                             "function() return 'x' end } }"),
                       "test.lua:4: objective odd returned string, not a number"));
}

BOOST_AUTO_TEST_CASE(a_descriptor_names_as_many_numbers_as_behaviour_returns) {
    BOOST_TEST(test::contains(trial("descriptor = { { name = 'size' } }"),
                              "behaviour returned 2 numbers, and descriptor names 1"));
    BOOST_TEST(trial("descriptor = { { name = 'x' }, { name = 'y' } }") == "");
}

BOOST_AUTO_TEST_CASE(a_function_sees_the_parameters_of_its_setting) {
    BOOST_TEST(fitness_of("parameters.cell_limit") == 256);
    BOOST_TEST(fitness_of("parameters.gait_time == 'held' and 1 or 0") == 1);
    BOOST_TEST(fitness_of("penalty") == 1);
    Parameters parameters;
    set_parameter(parameters, "cell_limit", 99);
    JudgingFunctions functions(with("fitness = function(life, parameters) return parameters.cell_limit end"),
                               0, parameters);
    BOOST_TEST(functions.judge(life_at(1)).fitness == 99);
}

BOOST_AUTO_TEST_CASE(a_function_sees_only_parameters_that_decide_lives) {
    const auto reading = [](const std::string &name) {
        return trial("fitness = function(life, parameters) return parameters." + name + " end");
    };
    BOOST_TEST(reading("population") == "");
    BOOST_TEST(test::contains(reading("confidence"),
                              "test.lua:4: parameters has no 'confidence': statistics alone read it"),
               reading("confidence"));
    for (const char *name : {"seeds", "generations"})
        BOOST_TEST(test::contains(reading(name), "': how much is run must not change how a life is judged"));
    // Neither does walking through all of them.
    BOOST_TEST(
        fitness_of("(function() local n = 0 for name in pairs(parameters) do if name == 'seeds' or name "
                   "== 'generations' or name == 'confidence' then n = n + 1 end end return n end)()") == 0);
}

BOOST_AUTO_TEST_CASE(a_misspelt_field_is_found_before_the_start) {
    const std::string message = trial("fitness = function(life) return life.displacment end");
    BOOST_TEST(test::contains(message, "test.lua:4: life has no 'displacment'; did you mean 'displacement'?"),
               message);
    BOOST_TEST(test::contains(trial("fitness = function(life, parameters) return parameters.cell_limits end"),
                              "test.lua:4: parameters has no 'cell_limits'; did you mean 'cell_limit'?"));
    BOOST_TEST(test::contains(trial("behaviour = function(life) return { life.finish.z } end"),
                              "test.lua:4: a point has no 'z'"));
    BOOST_TEST(test::contains(trial("fitness = function(life) return life.finish.x.y end"), "test.lua:4: "));
}

BOOST_AUTO_TEST_CASE(a_value_of_another_kind_is_found_before_the_start) {
    BOOST_TEST(
        test::contains(trial("fitness = function() end"), "test.lua:4: fitness returned nil, not a number"));
    BOOST_TEST(test::contains(trial("penalty = function() return 'x' end"),
                              "penalty returned string, not a number"));
    BOOST_TEST(test::contains(trial("behaviour = function() return 5 end"), "behaviour returned number"));
    BOOST_TEST(test::contains(trial("behaviour = function() return {} end"), "a list of 1 … 16 numbers"));
    BOOST_TEST(
        test::contains(trial("behaviour = function() return { 'x' } end"), "behaviour returned string"));
}

BOOST_AUTO_TEST_CASE(an_individual_that_cannot_be_judged_is_invalid_and_counted) {
    for (const char *expression :
         {"0/0", "1/0", "1e101", "-1", "nil", "'ten'", "life.nothing", "error('no')", "error({})"}) {
        JudgingFunctions functions(with("fitness = function(life) return life.finish.x > 5 and (" +
                                        std::string(expression) + ") or 1 end"),
                                   0, {});
        const Evaluation good = functions.judge(life_at(1)), bad = functions.judge(life_at(8));
        if (std::string(expression) == "nil") continue; // nil or 1 is 1
        BOOST_TEST(good.fitness == 1, expression);
        BOOST_TEST(bad.penalty == 0, expression);
        BOOST_TEST(bad.fitness == 0, expression);
        BOOST_TEST(bad.behaviour.empty(), expression);
        BOOST_TEST(functions.invalid() == 1, expression);
        BOOST_TEST(test::contains(functions.first_problem(), "test.lua:4: "), functions.first_problem());
        functions.judge(life_at(9));
        BOOST_TEST(functions.invalid() == 2, expression);
        functions.begin_run();
        BOOST_TEST(functions.invalid() == 0, expression);
    }
}

BOOST_AUTO_TEST_CASE(a_penalty_outside_0_to_1_is_invalid) {
    for (const char *penalty : {"2", "-0.5", "0/0"}) {
        JudgingFunctions functions(with("penalty = function() return " + std::string(penalty) + " end"), 0,
                                   {});
        BOOST_TEST(!functions.judge(life_at(1)).valid(), penalty);
        BOOST_TEST(functions.invalid() == 1, penalty);
    }
}

BOOST_AUTO_TEST_CASE(descriptors_of_a_run_have_one_length) {
    JudgingFunctions functions(
        with("behaviour = function(life) if life.finish.x > 5 then return { 1, 2, 3 } end return { 1 } end"),
        0, {});
    BOOST_TEST(functions.judge(life_at(1)).valid());
    BOOST_TEST(functions.judge(life_at(2)).valid());
    BOOST_TEST(!functions.judge(life_at(8)).valid());
}

BOOST_AUTO_TEST_CASE(a_function_that_depends_on_earlier_calls_is_found) {
    const char *counter = "fitness = function() n = n + 1 return n end";
    BOOST_TEST(
        test::contains(trial(counter, "local n = 0"), "test.lua:4: fitness changes what it closes over"));
    BOOST_TEST(
        test::contains(trial("behaviour = function(life) t[#t + 1] = 1 return { #t } end", "local t = {}"),
                       "test.lua:4: behaviour changes what it closes over: how a life is judged must not "
                       "depend on other lives"));
    // One that does so only after the trial is found during the run.
    JudgingFunctions late(
        with("fitness = function(life) if life.finish.x == 7 then n = n + 1 end return n end", "local n = 1"),
        0, {});
    BOOST_CHECK_NO_THROW(late.try_out());
    BOOST_CHECK_THROW(for (int i = 0; i < 100; ++i) late.judge(life_at(7)), InputError);
}

BOOST_AUTO_TEST_CASE(a_function_that_changes_what_it_closes_over_is_found_on_any_call) {
    struct Case {
        const char *before, *change;
    };
    const Case cases[] = {
        {"local n = 0", "n = n + 1"},
        {"local n = 0", "n = -n"}, // the sign of a zero
        {"local t = {}", "t.x = 1"},
        {"local t = { x = 1 }", "t.x = nil"},
        {"local t = { { { 'a' } } }", "t[1][1][1] = 'b'"},
        {"local t = { 2, 1 }", "table.sort(t)"},
        {"local t = {}", "t = {}"},
        {"local f = function() end", "f = function() end"},
        {"local function f() local n = 0 return function() n = n + 1 end end local g = f()", "g()"},
        {"local n = 0 local function g() n = n + 1 end local t = { g = g }", "t.g()"},
        {"local each, list, i = pairs { 1, 2, 3 }", "each(list, i)"},
        {"local d = require 'descriptors'", "d.x = 1"},
        {"", "local d = require 'descriptors' d.x = 1"},
        {"local name = 'descriptors' require(name)", "local d = require(name) d.x = 1"},
        {"local kept", "kept = life"},
        {"local kept", "kept = life.path"},
        {"local kept", "kept = parameters"},
        {"local n = 0", "n = n + 1 error('no')"},
        {"local t = { 1, 1, 1, 4 } t[1], t[2], t[3] = nil",
         "t.x, t.y, t.z = 1, 1, 1 t.x, t.y, t.z = nil"}, // its length
    };
    for (const auto &[before, change] : cases) {
        // Found right after the call, whose number is no sample.
        const std::string text = "fitness = function(life, parameters) if life.finish.x == 7 then " +
                                 std::string(change) + " end return 1 end";
        JudgingFunctions functions(with(text, before), 0, {});
        BOOST_CHECK_NO_THROW(functions.try_out());
        for (int i = 0; i < 10; ++i) BOOST_TEST(functions.judge(life_at(1)).fitness == 1, change);
        BOOST_CHECK_NO_THROW(functions.check_unchanged());
        const std::string message = test::refusal([&] { functions.judge(life_at(7)); });
        BOOST_TEST(message == "test.lua:4: fitness changes what it closes over: how a life is judged must "
                              "not depend on other lives",
                   change << " => " << message);
        BOOST_TEST(test::contains(test::refusal([&] { functions.memory(); }), "changed by a judgement"));
    }
}

BOOST_AUTO_TEST_CASE(a_function_may_read_what_it_closes_over) {
    const char *cases[] = {
        "local t = { 1, 2, x = { 3 } } for k, v in pairs(t) do t[k] = v end",
        "for i = 1, 3 do t[#t + 1] = i end for i = 1, 3 do t[#t] = nil end",
        "local m = require 'descriptors' m.shape(life)",
        "local s = ('x'):rep(1000) .. life.cells",
        "planula.change({ a = 1 }, { a = 2 })",
        "if life.cells == 3 then error('odd') end",
    };
    for (const std::string text : cases) {
        JudgingFunctions functions(
            with("fitness = function(life) " + text + " return 1 end", "local t = { 1, 2, 3 }"), 0, {});
        for (int i = 0; i < 100; ++i) functions.judge(life_at(i));
        BOOST_TEST(test::refusal([&] { functions.memory(); }) == "", text);
    }
}

BOOST_AUTO_TEST_CASE(a_function_that_closes_over_much_is_checked_after_every_life) {
    const std::string before = "local t = {} for i = 1, 20000 do t[i] = i end";
    const std::string changing = "fitness = function(life) t[life.cells] = life.finish.x return 1 end";
    JudgingFunctions functions(with(changing, before), 0, {});
    for (int i = 0; i < 4; ++i) BOOST_TEST(functions.judge(life_at(10)).fitness == 1);
    const std::string expected =
        "test.lua:4: what fitness closes over was changed by a judgement: how a life is "
        "judged must not depend on other lives";
    BOOST_TEST(test::refusal([&] { functions.judge(life_at(7)); }) == expected);
    BOOST_TEST(test::refusal([&] { functions.check_unchanged(); }) == expected);
    // While the script is checked, the function is named.
    BOOST_TEST(test::contains(trial("fitness = function(life) t[1] = 0 return 1 end", before),
                              "test.lua:4: fitness changes what it closes over"));
}

BOOST_AUTO_TEST_CASE(a_function_that_undoes_its_change_later_is_found) {
    // At an odd call, none of which after the first is judged twice, it changes a value, and at the next it restores it.
    JudgingFunctions functions(
        with("fitness = function(life) local odd = t[1] == 1 t[1] = life.finish.x return odd "
             "and 1 or 2 end",
             "local t = {} for i = 1, 5000 do t[i] = i end"),
        0, {});
    BOOST_TEST(functions.judge(life_at(1)).fitness == 1);
    BOOST_CHECK_THROW(functions.judge(life_at(2)), InputError);
}

BOOST_AUTO_TEST_CASE(a_behaviour_of_varying_length_is_invalid) {
    JudgingFunctions functions(
        with("behaviour = function(life) if life.finish.x > 5 then return { 1, 2, 3 } end return { 1 } end"),
        0, {});
    BOOST_TEST(functions.judge(life_at(1)).valid());
    for (int call = 2; call <= 1024; ++call) BOOST_TEST(!functions.judge(life_at(8)).valid(), call);
    BOOST_TEST(functions.first_problem() == "test.lua:4: behaviour returned 3 numbers, and 1 before");
}

BOOST_AUTO_TEST_CASE(a_life_is_read_only_and_unreadable_after_its_judgement) {
    BOOST_TEST(
        test::contains(trial("fitness = function(life) life.cells = 5 return 1 end"), "a life is read-only"));
    BOOST_TEST(test::contains(trial("fitness = function(life) life.finish.x = 5 return 1 end"),
                              "a life is read-only"));
    BOOST_TEST(test::contains(trial("fitness = function(_, parameters) parameters.seeds = 5 return 1 end"),
                              "parameters.seeds cannot be changed"));
    BOOST_TEST(test::contains(trial("fitness = function() total = 5 return 1 end"), "'total' is not local"));
    JudgingFunctions keeper(
        with("fitness = function(life) if kept then return kept.cells end kept = life return 1 end",
             "local kept"),
        0, {});
    BOOST_CHECK_THROW(keeper.judge(life_at(1)), InputError);
}

BOOST_AUTO_TEST_CASE(an_endless_function_makes_the_individual_invalid) {
    JudgingFunctions functions(with("fitness = function(life) while life.finish.x > 5 do end return 1 end"),
                               0, {});
    BOOST_TEST(functions.judge(life_at(1)).fitness == 1);
    BOOST_TEST(!functions.judge(life_at(8)).valid());
    BOOST_TEST(test::contains(functions.first_problem(), "executes too many instructions"));
    BOOST_TEST(functions.judge(life_at(2)).fitness == 1);
}

BOOST_AUTO_TEST_CASE(a_resumed_judge_has_its_earlier_counts) {
    const auto source =
        with("behaviour = function(life) if life.finish.x > 5 then return { 1, 2, 3 } end return { 1 } end");
    JudgingFunctions first(source, 0, {}), second(source, 0, {});
    // The 5th and 6th judgements are no samples that are judged twice.
    for (int i = 0; i < 4; ++i) first.judge(life_at(1));
    first.judge(life_at(8));
    BOOST_REQUIRE(first.invalid() == 1);
    second.continue_run(first.memory());
    BOOST_TEST(second.invalid() == 1);
    BOOST_TEST(second.first_problem() == first.first_problem());
    BOOST_TEST(second.memory() == first.memory());
    // The first behaviour of the run had one number, so that three are too many here, too.
    BOOST_TEST(!second.judge(life_at(8)).valid());
    second.begin_run();
    BOOST_TEST(second.judge(life_at(8)).valid());
    for (const std::string &memory : {std::string(), std::string("nonsense"), first.memory() + "x"})
        BOOST_TEST(!test::refusal([&] { second.continue_run(memory); }).empty());
}
