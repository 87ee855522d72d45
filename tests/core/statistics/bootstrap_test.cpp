// SPDX-License-Identifier: MIT
#include "statistics/bootstrap.h"

#include "base/error.h"
#include "statistics/effect_size.h"
#include "statistics/summary.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>
#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

namespace {

const std::vector<double> sample{12.1, 14.5, 9.8,  11.3, 15.2, 13.7, 10.4, 12.9, 16.1, 8.7,
                                 14.0, 12.2, 11.8, 13.1, 9.9,  15.8, 12.5, 10.9, 13.4, 11.1};
const Resampling usual{0.95, 10000, 1, 0};

} // namespace

BOOST_AUTO_TEST_CASE(the_interval_of_the_mean_is_that_of_r) {
    // quantile(replicate(1e6, mean(sample(v, 20, TRUE))), c(.025, .975)) in R 4.2.2: 11.600 and 13.350, with
    // an error of resampling of about 0.015 at 10 000 resamples.
    const Interval interval = bootstrap_mean(sample, usual);
    BOOST_TEST(std::abs(interval.low - 11.600) < 0.05);
    BOOST_TEST(std::abs(interval.high - 13.350) < 0.05);
}

BOOST_AUTO_TEST_CASE(the_interval_of_an_effect_size_is_that_of_r) {
    // A <- function(a, b) mean(outer(a, b, ">") + 0.5 * outer(a, b, "=="))
    // quantile(replicate(2e5, A(sample(a, 9, TRUE), sample(b, 9, TRUE))), c(.025, .975)): 0.432 and 1
    const std::vector<double> a{1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
    const std::vector<double> b{0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06001, 3.14, 1.295};
    const Interval interval = bootstrap(a, b, a12, usual);
    BOOST_TEST(std::abs(interval.low - 0.432) < 0.02);
    BOOST_TEST(std::abs(interval.high - 1) < 0.02);
}

BOOST_AUTO_TEST_CASE(more_confidence_is_wider) {
    const Interval half = bootstrap_mean(sample, {0.5, 10000, 1, 0}), most = bootstrap_mean(sample, usual);
    BOOST_TEST(most.low < half.low);
    BOOST_TEST(half.low < mean(sample));
    BOOST_TEST(mean(sample) < half.high);
    BOOST_TEST(half.high < most.high);
}

BOOST_AUTO_TEST_CASE(intervals_repeat_by_seed_and_key) {
    const auto low = [](std::uint64_t seed, std::uint32_t key) {
        return bootstrap_mean(sample, {0.95, 200, seed, key}).low;
    };
    BOOST_TEST(low(1, 0) == low(1, 0));
    BOOST_TEST(low(1, 0) != low(2, 0));
    BOOST_TEST(low(1, 0) != low(1, 1));
}

BOOST_AUTO_TEST_CASE(both_samples_are_resampled_each_by_itself) {
    // The difference of means of two independent samples varies more than either mean.
    const auto difference = [](std::span<const double> a, std::span<const double> b) {
        return mean(a) - mean(b);
    };
    const Interval both = bootstrap(sample, sample, difference, usual), one = bootstrap_mean(sample, usual);
    const double ratio = (both.high - both.low) / (one.high - one.low);
    BOOST_TEST(std::abs(ratio - std::sqrt(2.0)) < 0.05);
    BOOST_TEST(std::abs(both.high + both.low) < 0.1);
}

BOOST_AUTO_TEST_CASE(one_value_or_equal_values_leave_no_width) {
    for (const std::vector<double> &equal : {std::vector<double>{4.5}, std::vector<double>(20, 4.5)}) {
        const Interval interval = bootstrap_mean(equal, usual);
        BOOST_TEST(interval.low == 4.5);
        BOOST_TEST(interval.high == 4.5);
    }
}

BOOST_AUTO_TEST_CASE(an_invalid_sample_or_request_is_an_internal_error) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_THROW(bootstrap_mean(std::vector<double>{}, usual), InternalError);
    BOOST_CHECK_THROW(bootstrap_mean(std::vector<double>{1, nan}, usual), InternalError);
    BOOST_CHECK_THROW(bootstrap(sample, std::vector<double>{}, a12, usual), InternalError);
    BOOST_CHECK_THROW(bootstrap_mean(sample, {1, 100, 1, 0}), InternalError);
    BOOST_CHECK_THROW(bootstrap_mean(sample, {nan, 100, 1, 0}), InternalError);
    BOOST_CHECK_THROW(bootstrap_mean(sample, {0.95, 0, 1, 0}), InternalError);
}
