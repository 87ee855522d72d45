// SPDX-License-Identifier: MIT
#include "analysis/chance.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_bootstrap_seed_depends_on_its_name_alone) {
    BOOST_TEST(bootstrap_seed("curve a") == bootstrap_seed("curve a"));
    BOOST_TEST(bootstrap_seed("curve a") != bootstrap_seed("curve b"));
    // sha256("abc") starts with ba7816bf8f01cfea (FIPS 180-4).
    BOOST_TEST(bootstrap_seed("abc") == 0xba7816bf8f01cfeaU);
}
