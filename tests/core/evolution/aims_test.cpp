// SPDX-License-Identifier: MIT
#include "evolution/aims.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <limits>

using namespace planula;
using boost::test_tools::per_element;

BOOST_AUTO_TEST_CASE(a_value_outside_the_range_belongs_to_the_niche_at_its_edge) {
    const DescriptorNumber number{"size", 10, 30, 4}; // five wide
    for (const auto &[value, niche] : std::vector<std::pair<double, int>>{{10, 0},
                                                                          {14.9, 0},
                                                                          {15, 1},
                                                                          {24.9, 2},
                                                                          {25, 3},
                                                                          {29.9, 3},
                                                                          {30, 3},
                                                                          {31, 3},
                                                                          {1e100, 3},
                                                                          {9, 0},
                                                                          {-1e100, 0}})
        BOOST_TEST(niche_of(number, value) == niche, value);
}

BOOST_AUTO_TEST_CASE(higher_is_better_whatever_the_goal) {
    using enum Objective::Value;
    using enum Objective::Goal;
    const std::vector<Objective> objectives{{"work", stated, minimise},
                                            {"fitness", fitness, maximise},
                                            {"far", stated, maximise},
                                            {"novelty", novelty, maximise}};
    const std::vector<double> values{3, 4};
    BOOST_TEST(worths(objectives, 5, 6, values) == (std::vector<double>{-3, 5, 4, 6}), per_element());
    const Aims aims{objectives, {}};
    BOOST_TEST(aims.stated() == 2u);
    BOOST_TEST(aims.stated_titles() == (std::vector<std::string>{"objective_work", "objective_far"}),
               per_element());
}

BOOST_AUTO_TEST_CASE(objectives_that_cannot_be_compared_are_refused) {
    const auto refused = [](const std::vector<double> &objectives, double penalty) {
        try {
            check_objectives(std::vector<Evaluation>{{1, {0}, penalty, objectives}}, 2);
        } catch (const InputError &) {
            return true;
        }
        return false;
    };
    BOOST_TEST(!refused({1, -2}, 1));
    BOOST_TEST(!refused({}, 0)); // not valid
    BOOST_TEST(refused({1}, 1));
    BOOST_TEST(refused({1, std::numeric_limits<double>::quiet_NaN()}, 1));
    BOOST_TEST(refused({1, std::numeric_limits<double>::infinity()}, 1));
}
