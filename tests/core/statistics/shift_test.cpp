// SPDX-License-Identifier: MIT
#include "statistics/shift.h"

#include "base/error.h"
#include "core/statistics/reference.h"
#include "statistics/signed_rank.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace planula;
namespace tt = boost::test_tools;

BOOST_AUTO_TEST_CASE(estimates_and_intervals_are_those_of_r) {
    for (const Reference &r : references_of("shift")) {
        const Shift found =
            r.kind == "pairs" ? paired_shift(r.a, r.b, r.expected[0]) : shift(r.a, r.b, r.expected[0]);
        BOOST_TEST_CONTEXT(r.kind << " of " << r.a.size() << ", confidence " << r.expected[0]) {
            BOOST_TEST(found.estimate == r.expected[1], tt::tolerance(1e-12));
            BOOST_REQUIRE(found.interval.has_value());
            BOOST_TEST(found.interval->low == r.expected[2], tt::tolerance(1e-12));
            BOOST_TEST(found.interval->high == r.expected[3], tt::tolerance(1e-12));
        }
    }
}

BOOST_AUTO_TEST_CASE(the_interval_holds_the_shifts_that_the_test_does_not_reject) {
    const Reference r = references_of("shift").at(3); // pairs, confidence 0.95
    BOOST_REQUIRE(r.kind == "pairs");
    const Interval interval = paired_shift(r.a, r.b, 0.95).interval.value();
    const auto p = [&](double by) {
        std::vector<double> moved;
        for (const double value : r.b) moved.push_back(value + by);
        return signed_rank(r.a, moved).p;
    };
    BOOST_TEST(p(interval.low + 1e-9) > 0.05);
    BOOST_TEST(p(interval.low - 1e-9) <= 0.05);
    BOOST_TEST(p(interval.high - 1e-9) > 0.05);
    BOOST_TEST(p(interval.high + 1e-9) <= 0.05);
}

BOOST_AUTO_TEST_CASE(few_values_have_an_estimate_and_no_interval) {
    const std::vector<double> a{4, 5, 6}, b{1, 1.5, 2.5};
    for (const Shift &found : {shift(a, b, 0.95), paired_shift(a, b, 0.95)}) {
        BOOST_TEST(found.estimate > 3);
        BOOST_TEST(!found.interval.has_value());
    }
    BOOST_TEST(shift(a, b, 0.95).estimate == 3.5);
    BOOST_TEST(paired_shift(a, b, 0.95).estimate == 3.375);
    BOOST_TEST(shift(a, b, 0.8).interval.has_value());
}

BOOST_AUTO_TEST_CASE(invalid_samples_and_confidences_are_refused) {
    const std::vector<double> two{1, 2}, three{1, 2, 3};
    BOOST_CHECK_THROW(paired_shift(two, three, 0.95), InputError);
    BOOST_CHECK_THROW(shift(two, std::vector<double>{}, 0.95), InputError);
    BOOST_CHECK_EXCEPTION(shift(two, three, 95), InputError, [](const InputError &error) {
        return std::string(error.what()) == "confidence is between 0 and 1, not 95";
    });
}
