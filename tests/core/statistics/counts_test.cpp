// SPDX-License-Identifier: MIT
// Known answers are those of R 4.2.2, with the calls that the header names.
#include "statistics/counts.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_CASE(the_hypergeometric_tail_is_that_of_r) {
    BOOST_TEST(hypergeometric_tail(5, 40, 20, 5) == 15504.0 / 658008.0, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(2, 40, 3, 20) == 0.5, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(10, 100, 30, 25) == 0.156689905592093, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(3, 40, 20, 5) == 0.5, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(certain_counts_have_probability_one_and_impossible_ones_zero) {
    BOOST_TEST(hypergeometric_tail(0, 10, 4, 3) == 1, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(4, 10, 3, 5) == 0);
    BOOST_TEST(hypergeometric_tail(3, 10, 10, 3) == 1, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(0, 10, 0, 0) == 1);
}

BOOST_AUTO_TEST_CASE(the_binomial_tail_is_that_of_r) {
    BOOST_TEST(binomial_lower_tail(0, 20, 0.25) == 0.0031712119389339967, tolerance(1e-12));
    BOOST_TEST(binomial_lower_tail(1, 20, 0.25) == 0.024312624865160629, tolerance(1e-12));
    BOOST_TEST(binomial_lower_tail(2, 20, 0.25) == 0.091260432464878263, tolerance(1e-12));
    BOOST_TEST(binomial_lower_tail(7, 50, 0.1) == 0.8778549163987216, tolerance(1e-12));
    BOOST_TEST(binomial_lower_tail(20, 20, 0.25) == 1, tolerance(1e-12));
    BOOST_TEST(binomial_lower_tail(-1, 20, 0.25) == 0);
    BOOST_TEST(binomial_lower_tail(0, 0, 0.25) == 1);
}

BOOST_AUTO_TEST_CASE(more_marked_than_there_are_is_an_input_error) {
    BOOST_CHECK_THROW(hypergeometric_tail(1, 10, 11, 3), InputError);
    BOOST_CHECK_THROW(binomial_lower_tail(1, 10, 1.5), InputError);
}
