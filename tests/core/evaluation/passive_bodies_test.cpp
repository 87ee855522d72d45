// SPDX-License-Identifier: MIT
#include "support/passive.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::specimens;

BOOST_AUTO_TEST_CASE(hardly_any_passive_body_keeps_moving) {
    // At most 0.2 % of random bodies; `make torture` drops thousands.
    int bodies = 0;
    for (std::uint64_t number = 0; bodies < 40; ++number)
        if (const auto rest = drop(Actuation::oscillator, number, Parameters{}.settling.settle_limit)) {
            ++bodies;
            BOOST_TEST(!rest->moving, number);
            BOOST_TEST(rest->steps >= Parameters{}.settling.settle_window);
        }
}
