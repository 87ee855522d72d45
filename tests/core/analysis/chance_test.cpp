// SPDX-License-Identifier: MIT
#include "analysis/chance.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using boost::test_tools::tolerance;

BOOST_AUTO_TEST_CASE(the_hypergeometric_tail_is_that_of_r) {
    // phyper(marked - 1, all_marked, total - all_marked, drawn, lower.tail = FALSE)
    BOOST_TEST(hypergeometric_tail(5, 40, 20, 5) == 15504.0 / 658008.0, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(2, 40, 3, 20) == 0.5, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(10, 100, 30, 25) == 0.156689905592093, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(3, 40, 20, 5) == 0.5, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(what_must_happen_is_certain_and_what_cannot_is_not) {
    BOOST_TEST(hypergeometric_tail(0, 10, 4, 3) == 1, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(4, 10, 3, 5) == 0);
    BOOST_TEST(hypergeometric_tail(3, 10, 10, 3) == 1, tolerance(1e-12));
    BOOST_TEST(hypergeometric_tail(0, 10, 0, 0) == 1);
}

BOOST_AUTO_TEST_CASE(a_bootstrap_seed_depends_on_its_name_alone) {
    BOOST_TEST(bootstrap_seed("curve a") == bootstrap_seed("curve a"));
    BOOST_TEST(bootstrap_seed("curve a") != bootstrap_seed("curve b"));
    // sha256("abc") starts with ba7816bf8f01cfea (FIPS 180-4).
    BOOST_TEST(bootstrap_seed("abc") == 0xba7816bf8f01cfeaU);
}
