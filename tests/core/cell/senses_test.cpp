// SPDX-License-Identifier: MIT
#include "cell/senses.h"

#include "cell/channels.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_cell_reads_place_neighbours_and_time) {
    const auto inputs = sense({3, -4}, 0.25, 0.5, NetworkParameters{});
    const auto near = boost::test_tools::tolerance(1e-15);
    BOOST_TEST(inputs[input::x] == 0.3, near);
    BOOST_TEST(inputs[input::y] == -0.4, near);
    BOOST_TEST(inputs[input::maternal_east] == std::exp(-std::sqrt(49.0 + 16) / 10), near);
    BOOST_TEST(inputs[input::maternal_west] == std::exp(-std::sqrt(169.0 + 16) / 10), near);
    BOOST_TEST(inputs[input::maternal_north] == std::exp(-std::sqrt(9.0 + 196) / 10), near);
    BOOST_TEST(inputs[input::maternal_south] == std::exp(-std::sqrt(9.0 + 36) / 10), near);
    BOOST_TEST(inputs[input::morphogen] == 0.25);
    BOOST_TEST(inputs[input::time] == 0.5);
    BOOST_TEST(inputs[input::bias] == 1);
}

BOOST_AUTO_TEST_CASE(the_order_of_inputs_and_outputs_is_that_of_the_rules) {
    BOOST_TEST(input::count == 9);
    BOOST_TEST(input::bias == 8);
    BOOST_TEST(output::count(Actuation::oscillator) == 6);
    BOOST_TEST(output::count(Actuation::grn) == 5);
    BOOST_TEST(output::period == 4);
    BOOST_TEST(output::phase == 5);
    BOOST_TEST(output::spring == 4);
}

BOOST_AUTO_TEST_CASE(a_cell_without_neighbours_reads_no_morphogen) {
    const std::vector<double> morphogens{0.5, -0.25, 1};
    BOOST_TEST(mean_morphogen({}, morphogens) == 0);
    BOOST_TEST(mean_morphogen(std::vector<int>{0, 1}, morphogens) == 0.125);
}
