// SPDX-License-Identifier: MIT
#include "statistics/benjamini_hochberg.h"

#include "base/error.h"
#include "core/statistics/reference.h"
#include "statistics/holm.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(corrected_p_values_are_those_of_r) {
    for (const Reference &r : references_of("benjamini_hochberg")) {
        const std::vector<double> found = benjamini_hochberg(r.a);
        BOOST_REQUIRE(found.size() == r.expected.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            BOOST_TEST(found[i] == r.expected[i], tt::tolerance(1e-12));
    }
}

BOOST_AUTO_TEST_CASE(it_is_never_stricter_than_holm) {
    const std::vector<double> p{0.01, 0.04, 0.03, 0.005, 0.5, 0.03}, lenient = benjamini_hochberg(p),
                                                                     strict = holm(p);
    for (std::size_t i = 0; i < p.size(); ++i) BOOST_TEST((p[i] <= lenient[i] && lenient[i] <= strict[i]));
    BOOST_TEST(benjamini_hochberg(std::vector<double>{}).empty());
}

BOOST_AUTO_TEST_CASE(a_value_outside_0_and_1_is_an_input_error) {
    for (const double bad : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()})
        BOOST_CHECK_THROW(benjamini_hochberg(std::vector<double>{0.5, bad}), InputError);
}
