// SPDX-License-Identifier: MIT
#include "experiment/world_numbers.h"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace planula;

namespace {

const WorldNumber &number(std::string_view name) {
    for (const WorldNumber &each : world_numbers())
        if (each.name == name) return each;
    throw std::runtime_error("no such number");
}

} // namespace

BOOST_AUTO_TEST_CASE(every_number_reads_and_writes_its_own_place) {
    Spec spec;
    double value = 1;
    for (const WorldNumber &each : world_numbers()) each.in(spec) = value++;
    value = 1;
    for (const WorldNumber &each : world_numbers()) BOOST_TEST(value_of(each, spec) == value++, each.name);
    BOOST_TEST(world_numbers().size() == 8u);
    BOOST_TEST(spec.environment.gravity == 1);
    BOOST_TEST(spec.environment.flow.y == 7);
    BOOST_TEST(spec.actuation_range == 8);
}

BOOST_AUTO_TEST_CASE(the_papers_parameters_exist_and_have_the_same_units) {
    for (const bool has_ground : {false, true})
        for (const WorldNumber &each : world_numbers()) {
            const std::string_view name = each.standard({.has_ground = has_ground});
            if (name.empty()) continue;
            BOOST_TEST(parameter_row(name).unit == each.unit, name);
            BOOST_TEST(is_of_worlds(name), name);
        }
    BOOST_TEST(!is_of_worlds("settle_speed"));
}

BOOST_AUTO_TEST_CASE(a_number_has_the_source_that_the_experiment_names_or_is_stated) {
    Spec spec;
    spec.world_sources = {{"gravity", "gravity"}, {"friction", "gravity"}};
    BOOST_TEST(source_of(number("friction"), spec) == "gravity");
    BOOST_TEST(source_of(number("drag normal"), spec) == "");
    BOOST_TEST(makes_world("gravity", spec));
    BOOST_TEST(!makes_world("friction", spec));
    BOOST_TEST(stated_instead_of("gravity", spec) == nullptr);
    BOOST_TEST(stated_instead_of("friction", spec) == nullptr); // it is taken from gravity
    BOOST_TEST(stated_instead_of("drag_normal", spec) == &number("drag normal"));
    BOOST_TEST(stated_instead_of("actuation_range_terrestrial", spec) == nullptr);
    BOOST_TEST(stated_instead_of("actuation_range_aquatic", spec) == &number("actuation_range"));
}
