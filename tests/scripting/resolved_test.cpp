// SPDX-License-Identifier: MIT
#include "scripting/schema.h"

#include "base/hash.h"
#include "scripting/lua_state.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::string resolved(const std::string &text, const Overrides &overrides = {}) {
    const Experiment e = load_experiment(
        test::script("local paper = require 'paper' return paper.experiment " + text), overrides);
    return resolved_text(e, e.settings[0]);
}

} // namespace

BOOST_AUTO_TEST_CASE(the_resolved_setting_is_lua_that_holds_every_value_to_the_bit) {
    const std::string text =
        resolved("{ name = 'x', environment = paper.terrestrial { ground = { { -0.1, 1/3 }, { 2, 0 } } }, "
                 "parameters = { spring_stiffness = 1000/3 } }");
    const auto sources = test::script(text);
    const LuaState state(sources, sources->script());
    const Value *parameters = state.result().find("parameters"),
                *environment = state.result().find("environment");
    BOOST_REQUIRE(parameters && environment);
    Parameters expected;
    expected.spring_stiffness = 1000.0 / 3;
    for (const ParameterRow &row : parameter_rows()) {
        const Value *value = parameters->find(row.name);
        BOOST_REQUIRE_MESSAGE(value, row.name);
        BOOST_TEST(value->number == parameter(expected, row.name), row.name);
    }
    const Value &ground = *environment->find("ground");
    BOOST_TEST(ground.list.at(0).list.at(0).number == -0.1);
    BOOST_TEST(ground.list.at(0).list.at(1).number == 1.0 / 3);
    BOOST_TEST(environment->find("drag")->find("normal")->number == 0);
}

BOOST_AUTO_TEST_CASE(anything_that_decides_results_changes_the_resolved_text) {
    const std::string base = resolved("{ name = 'x' }");
    BOOST_TEST(base == resolved("{ name = 'x' }"));
    BOOST_TEST(base != resolved("{ name = 'x' }", {{"population", 17}}));
    BOOST_TEST(base != resolved("{ name = 'x', search = 'novelty' }"));
    BOOST_TEST(resolved("{ name = 'x', start = { generations = 3, behaviour = paper.judgement.behaviour } }")
                   .find("start = { generations = 3 }") != std::string::npos);
    BOOST_TEST(base.find("start =") == std::string::npos);
    BOOST_TEST(base != resolved("{ name = 'x', actuation = 'grn' }"));
    BOOST_TEST(base != resolved("{ name = 'x', environment = paper.aquatic { flow = { x = 1, y = 0 } } }"));
    BOOST_TEST(base != resolved("{ name = 'x', fitness = function() return 1 end }"));
}

BOOST_AUTO_TEST_CASE(the_code_of_the_script_and_its_modules_is_hashed_and_statistics_are_not) {
    const std::string text = resolved("{ name = 'x' }");
    const std::string script = "local paper = require 'paper' return paper.experiment { name = 'x' }";
    BOOST_TEST(test::contains(text, "{ name = \"script\", sha256 = \"" + sha256(script) + "\" }"));
    for (const char *module : {"paper", "paper.judgement", "paper.environments"})
        BOOST_TEST(test::contains(text, "{ name = \"" + std::string(module) + "\", sha256 = "), module);
    BOOST_TEST(!test::contains(text, "paper.summary"));
    BOOST_TEST(!test::contains(text, PLANULA_SOURCE_DIR));
}
