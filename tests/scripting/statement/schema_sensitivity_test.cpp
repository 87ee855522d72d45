// SPDX-License-Identifier: MIT
#include "statement/schema_sensitivity.h"

#include "statement/schema.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

SensitivityPlan plan_of(const std::string &table) {
    return load_experiment(test::script("return require 'paper'.experiment { name = 'x'" + table + " }"))
        .sensitivity;
}

std::string refused(const std::string &table) {
    return test::refusal([&] { plan_of(", sensitivity = " + table); });
}

} // namespace

BOOST_AUTO_TEST_CASE(keys_that_are_not_stated_have_standard_values) {
    const SensitivityPlan none = plan_of(""), empty = plan_of(", sensitivity = {}");
    for (const SensitivityPlan &plan : {none, empty}) {
        BOOST_TEST(plan.sample == 200);
        BOOST_TEST((plan.factors == std::vector{0.5, 2.0}));
        BOOST_TEST(plan.parameters.empty());
    }
}

BOOST_AUTO_TEST_CASE(sample_factors_and_parameters_are_as_stated) {
    const SensitivityPlan plan = plan_of(
        ", sensitivity = { sample = 7, factors = { 0.9, 1.1, 3 }, parameters = { 'gravity', 'friction' } }");
    BOOST_TEST(plan.sample == 7);
    BOOST_TEST((plan.factors == std::vector{0.9, 1.1, 3.0}));
    BOOST_TEST((plan.parameters == std::vector<std::string>{"gravity", "friction"}));
}

BOOST_AUTO_TEST_CASE(invalid_plans_are_refused_with_the_rule_and_the_nearest_name) {
    const auto says = [](const std::string &table, const std::string &part) {
        const std::string said = refused(table);
        BOOST_TEST(test::contains(said, "test.lua:1: "), said);
        BOOST_TEST(test::contains(said, part), said);
    };
    says("{ sample = 0 }", "sensitivity.sample must be at least 1");
    says("{ factors = { 2, -1 } }", "sensitivity.factors[2] must be a number above 0");
    says("{ factors = { 'two' } }", "sensitivity.factors[1] must be a number above 0");
    says("{ factors = {} }", "sensitivity.factors is empty");
    says("{ parameters = { 'gravty' } }", "did you mean 'gravity'?");
    says("{ parameters = { 5 } }", "sensitivity.parameters[1] must be a parameter's name");
    says("{ smple = 5 }", "sample");
}
