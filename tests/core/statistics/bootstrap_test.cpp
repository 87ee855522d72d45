// SPDX-License-Identifier: MIT
#include "statistics/bootstrap.h"

#include "base/error.h"
#include "core/statistics/reference.h"
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

std::vector<double> more_than(std::span<const double> values, double by) {
    std::vector<double> result;
    for (const double value : values) result.push_back(value + by);
    return result;
}

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

BOOST_AUTO_TEST_CASE(an_invalid_sample_or_request_is_an_input_error) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    BOOST_CHECK_THROW(bootstrap_mean(std::vector<double>{}, usual), InputError);
    BOOST_CHECK_THROW(bootstrap_mean(std::vector<double>{1, nan}, usual), InputError);
    BOOST_CHECK_THROW(bootstrap(sample, std::vector<double>{}, a12, usual), InputError);
    BOOST_CHECK_THROW(bootstrap_mean(sample, {1, 100, 1, 0}), InputError);
    BOOST_CHECK_THROW(bootstrap_mean(sample, {nan, 100, 1, 0}), InputError);
    BOOST_CHECK_THROW(bootstrap_mean(sample, {0.95, 0, 1, 0}), InputError);
}

BOOST_AUTO_TEST_CASE(the_bca_interval_of_given_replicates_is_that_of_r) {
    for (const Reference &r : references_of("bca")) {
        const Interval found = bca_interval(r.expected[1], r.a, r.b, r.expected[0]);
        BOOST_TEST(found.low == r.expected[2], tt::tolerance(1e-9));
        BOOST_TEST(found.high == r.expected[3], tt::tolerance(1e-9));
    }
}

BOOST_AUTO_TEST_CASE(the_influences_of_a_bca_interval_are_those_of_leaving_one_value_out) {
    // The replicates of a bootstrap are caught on their way; the influences of the mean are the distances from it.
    std::vector<double> seen, distances;
    Resampling bca = usual;
    bca.kind = IntervalKind::bca, bca.resamples = 500;
    const Interval found = bootstrap(
        sample, [&](std::span<const double> values) { return seen.push_back(mean(values)), seen.back(); },
        bca);
    seen.resize(500);
    for (const double value : sample) distances.push_back(value - mean(sample));
    const Interval given = bca_interval(mean(sample), seen, distances, 0.95);
    BOOST_TEST(found.low == given.low, tt::tolerance(1e-12));
    BOOST_TEST(found.high == given.high, tt::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(a_bca_interval_moves_towards_the_long_tail) {
    std::vector<double> skewed;
    for (const double value : sample) skewed.push_back(value * value * value * value);
    Resampling bca = usual;
    bca.kind = IntervalKind::bca;
    const Interval plain = bootstrap_mean(skewed, usual), moved = bootstrap_mean(skewed, bca);
    BOOST_TEST(plain.low < moved.low);
    BOOST_TEST(plain.high < moved.high);
}

BOOST_AUTO_TEST_CASE(pairs_are_resampled_together) {
    // The difference of pairs that differ by a constant does not vary, of independent samples it does.
    const std::vector<double> more = more_than(sample, 2);
    const auto difference = [](std::span<const double> a, std::span<const double> b) {
        return mean(a) - mean(b);
    };
    const Interval pairs = bootstrap_pairs(more, sample, difference, usual),
                   samples = bootstrap(more, sample, difference, usual);
    BOOST_TEST(pairs.high - pairs.low < 1e-12);
    BOOST_TEST(samples.high - samples.low > 1);
    Resampling bca = usual;
    bca.kind = IntervalKind::bca;
    const Interval superiority = bootstrap_pairs(more, sample, a12, bca);
    BOOST_TEST(superiority.low < a12(more, sample));
    BOOST_TEST(a12(more, sample) < superiority.high);
}

BOOST_AUTO_TEST_CASE(what_has_no_bca_interval_is_an_input_error_or_a_point) {
    const std::vector<double> equal(20, 4.5), one{1};
    Resampling bca = usual;
    bca.kind = IntervalKind::bca;
    BOOST_TEST(bootstrap_mean(equal, bca).low == 4.5);
    BOOST_TEST(bootstrap(more_than(sample, 100), sample, a12, bca).low == 1);
    BOOST_CHECK_THROW(bootstrap_mean(one, bca), InputError);
    const auto smallest = [](std::span<const double> values) { return quantile(values, 0); };
    BOOST_CHECK_THROW(bootstrap(sample, smallest, bca), InputError); // none below the estimate
    BOOST_CHECK_THROW(bootstrap_pairs(sample, one, a12, usual), InputError);
}
