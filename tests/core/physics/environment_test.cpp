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

BOOST_AUTO_TEST_CASE(obstacles_that_break_a_rule_are_refused_with_it) {
    const auto obstacle = [](std::vector<Vec2d> points) {
        Environment environment = specimens::land();
        environment.obstacles.push_back({std::move(points)});
        return environment;
    };
    check_environment(obstacle({{5, 0}, {6, 0}, {6, 3}, {5, 3}}));
    check_environment(obstacle({{5, 3}, {6, 3}, {6, 0}, {5, 0}}));
    check_environment(obstacle({{5, 0}, {5 + 1e-7, 0}, {5 + 1e-7, 3}, {5, 3}}));
    refused(obstacle({{5, 0}, {6, 0}}), "three points");
    refused(obstacle({{5, 0}, {6, 0}, {5, 3e9}}), "within 1e+09");
    refused(obstacle({{5, 0}, {6, 0}, {5, std::nan("")}}), "finite");
    refused(obstacle({{5, 0}, {5.1, 0}, {5, 0.1}}), "a cell long or more");
    refused(obstacle({{5, 0}, {7, 0}, {6, 0}}), "must not cross or touch itself");
    refused(obstacle({{5, 0}, {7, 0}, {7, 0}, {6, 2}}), "must not cross or touch itself");
    refused(obstacle({{5, 0}, {7, 0}, {7, 2}, {6, 0}}), "must not cross or touch itself");
    refused(obstacle({{0.3, 0.5}, {3, 0}, {3, 3}}), "its distance from (0, 0.5) must be half a cell or more");
    refused(obstacle({{-9, -1}, {9, -1}, {9, 9}, {-9, 9}}),
            "its distance from (0, 0.5) must be half a cell or more");
    Environment many = specimens::land();
    many.obstacles.push_back({std::vector<Vec2d>(10001, {5, 1})});
    refused(many, "10000 points in all");
    Environment slippery = obstacle({{5, 0}, {6, 0}, {6, 3}});
    slippery.obstacles[0].friction = -1;
    refused(slippery, "the friction of obstacle 1");
}

BOOST_AUTO_TEST_CASE(ceilings_and_patches_that_break_a_rule_are_refused_with_it) {
    Environment environment = specimens::land();
    environment.ground = {{-5, 0}, {0, 3}, {5, 0}};
    environment.ceiling = {{-5, 2}, {5, 2}};
    refused(environment, "at x = 0 it is, not -1");
    environment.ceiling = {{-5, 5}, {5, 5}};
    check_environment(environment);
    environment.ceiling = {{-5, 9}, {5, 0.5}};
    refused(environment, "a cell or more above the ground; at x = 5");
    environment.ceiling = {{-5, 5}};
    refused(environment, "two points");
    Environment water = specimens::water();
    water.friction_patches = {{0, 1, 0.5}};
    refused(water, "friction patches are of ground and ceiling");
    water.ceiling = {{-1, 2}, {1, 2}};
    check_environment(water);
    water.friction_patches = {{0, 1, 0.5}, {0.5, 2, 0.5}};
    refused(water, "ascend and not overlap");
    water.friction_patches = {{0, 1, -0.5}};
    refused(water, "the friction of a patch");
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
