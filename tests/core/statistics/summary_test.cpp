// SPDX-License-Identifier: MIT
#include "statistics/summary.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(quantiles_are_those_of_r) {
    // quantile(c(2.5, -1, 7, 3.25, 0, 11), p, type = 7)
    const std::vector<double> sample{2.5, -1, 7, 3.25, 0, 11};
    BOOST_TEST(quantile(sample, 0) == -1);
    BOOST_TEST(quantile(sample, 0.025) == -0.875, tt::tolerance(1e-15));
    BOOST_TEST(quantile(sample, 0.1) == -0.5);
    BOOST_TEST(quantile(sample, 0.25) == 0.625);
    BOOST_TEST(quantile(sample, 0.5) == 2.875);
    BOOST_TEST(quantile(sample, 0.77) == 6.4375, tt::tolerance(1e-15));
    BOOST_TEST(quantile(sample, 0.975) == 10.5, tt::tolerance(1e-15));
    BOOST_TEST(quantile(sample, 1) == 11);
}

BOOST_AUTO_TEST_CASE(mean_and_median_of_few_values) {
    BOOST_TEST(mean(std::vector<double>{1, 2, 6}) == 3);
    BOOST_TEST(median(std::vector<double>{6, 1, 2}) == 2);
    BOOST_TEST(median(std::vector<double>{6, 1, 2, 4}) == 3);
}

BOOST_AUTO_TEST_CASE(one_value_or_equal_values_are_their_own_summary) {
    for (const std::vector<double> &sample : {std::vector<double>{4.5}, {4.5, 4.5, 4.5, 4.5}}) {
        BOOST_TEST(mean(sample) == 4.5);
        BOOST_TEST(median(sample) == 4.5);
        BOOST_TEST(quantile(sample, 0.025) == 4.5);
        BOOST_TEST(quantile(sample, 1) == 4.5);
    }
}

BOOST_AUTO_TEST_CASE(empty_samples_and_values_that_are_not_finite_are_refused) {
    const double nan = std::numeric_limits<double>::quiet_NaN(),
                 inf = std::numeric_limits<double>::infinity();
    for (const std::vector<double> &sample : {std::vector<double>{}, {nan}, {1, nan}, {1, inf}, {-inf}}) {
        BOOST_CHECK_THROW(mean(sample), InputError);
        BOOST_CHECK_THROW(median(sample), InputError);
    }
    BOOST_CHECK_THROW(quantile(std::vector<double>{1}, 1.5), InputError);
    BOOST_CHECK_THROW(quantile(std::vector<double>{1}, nan), InputError);
}
