// SPDX-License-Identifier: MIT
// Known answers are those of R 4.2.2, p.adjust(p, "holm").
#include "statistics/holm.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(corrected_p_values_are_those_of_r) {
    const std::vector<double> p{0.01, 0.04, 0.03, 0.005, 0.5, 0.03},
        expected{0.05, 0.12, 0.12, 0.03, 0.5, 0.12};
    const std::vector<double> found = holm(p);
    BOOST_REQUIRE(found.size() == p.size());
    for (std::size_t i = 0; i < p.size(); ++i) BOOST_TEST(found[i] == expected[i], tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(one_test_needs_no_correction_and_none_can_exceed_one) {
    BOOST_TEST((holm(std::vector<double>{0.03}) == std::vector<double>{0.03}));
    BOOST_TEST((holm(std::vector<double>{0.9, 0.8}) == std::vector<double>{1, 1}));
    BOOST_TEST(holm(std::vector<double>{}).empty());
}

BOOST_AUTO_TEST_CASE(a_value_outside_0_and_1_is_an_input_error) {
    for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
        BOOST_CHECK_THROW(holm(std::vector<double>{0.5, bad}), InputError);
}
