// SPDX-License-Identifier: MIT
#include "statistics/distributions.h"

#include "base/error.h"
#include "core/statistics/reference.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <numeric>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(quantiles_of_the_normal_distribution_are_those_of_r) {
    for (const Reference &r : references_of("normal_quantile"))
        for (std::size_t i = 0; i < r.a.size(); ++i) {
            BOOST_TEST(std::abs(normal_quantile(r.a[i]) - r.expected[i]) < 1e-10);
            BOOST_TEST(normal_below(r.expected[i]) == r.a[i], tt::tolerance(1e-11));
        }
}

BOOST_AUTO_TEST_CASE(p_of_student_is_that_of_r) {
    for (const Reference &r : references_of("student"))
        for (std::size_t i = 0; i < r.a.size(); ++i)
            BOOST_TEST(student_beyond(-r.a[i], static_cast<int>(r.b[0])) == r.expected[i],
                       tt::tolerance(1e-10));
    BOOST_TEST(student_beyond(0, 3) == 1);
    BOOST_TEST(student_beyond(std::numeric_limits<double>::infinity(), 3) == 0);
}

BOOST_AUTO_TEST_CASE(sums_of_ranks_are_counted) {
    // Of 1, 2, 3: two have the sums 3, 4 and 5; signs give 0, 1, 2, 3 twice, 4, 5 and 6.
    BOOST_TEST((ways_to_sum({1, 2, 3}, 2) == std::vector<double>{0, 0, 0, 1, 1, 1}));
    const double e = 1.0 / 8;
    BOOST_TEST((chances_of_signed_sums({1, 2, 3}) == std::vector<double>{e, e, e, 2 * e, e, e, e}));
}

BOOST_AUTO_TEST_CASE(what_no_distribution_has_is_refused) {
    for (const double p : {0.0, 1.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
        BOOST_CHECK_THROW(normal_quantile(p), InputError);
    BOOST_CHECK_THROW(student_beyond(1, 0), InputError);
}
