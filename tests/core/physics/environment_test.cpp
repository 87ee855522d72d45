// SPDX-License-Identifier: MIT
#include "physics/environment.h"

#include "base/error.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace planula;

namespace {

void refused(const Environment &environment, const std::string &rule) {
    BOOST_CHECK_EXCEPTION(check_environment(environment), InputError, [&](const InputError &error) {
        return std::string(error.what()).find(rule) != std::string::npos;
    });
}

} // namespace

BOOST_AUTO_TEST_CASE(the_papers_worlds_and_mixtures_are_accepted) {
    check_environment(specimens::water());
    check_environment(specimens::land());
    check_environment(specimens::empty_space());
    check_environment(
        {.gravity = 1, .has_ground = true, .friction = 0.1, .drag_normal = 1, .flow = {0.5, 0}});
}

BOOST_AUTO_TEST_CASE(invalid_values_are_refused_with_the_rule_and_the_value) {
    refused({.gravity = -1, .has_ground = true}, "gravity must be a finite number, 0 or more, not -1");
    refused({.friction = -0.5}, "friction");
    refused({.drag_normal = std::nan("")}, "normal drag");
    refused({.drag_tangential = std::numeric_limits<double>::infinity()}, "tangential drag");
    refused({.flow = {0, std::nan("")}}, "flow must be finite");
    refused({.gravity = 5}, "fall for ever");
    refused({.has_ground = true, .ground = {{0, 0}}}, "two points");
    refused({.has_ground = true, .ground = {{0, 0}, {0, 1}}}, "ascend in x");
    refused({.has_ground = true, .ground = {{0, 0}, {1, std::nan("")}}}, "finite");
    refused({.has_ground = true, .ground = {{0, 0}, {1, 2e9}}}, "within 1e+09 of 0, not 2e+09");
    refused({.has_ground = true, .ground = {{-1e10, 0}, {1, 2}}}, "within 1e+09 of 0");
}

BOOST_AUTO_TEST_CASE(ground_is_linear_between_its_points_and_level_beyond) {
    const Environment hill{.has_ground = true, .ground = {{0, 1}, {2, 3}, {4, 0}}};
    BOOST_TEST(ground_height(hill, -5) == 1);
    BOOST_TEST(ground_height(hill, 0.5) == 1.5);
    BOOST_TEST(ground_height(hill, 2) == 3);
    BOOST_TEST(ground_height(hill, 3) == 1.5);
    BOOST_TEST(ground_height(hill, 9) == 0);
    BOOST_TEST(ground_height(specimens::land(), 7) == 0);
}
