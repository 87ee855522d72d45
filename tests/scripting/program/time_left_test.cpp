// SPDX-License-Identifier: MIT
#include "program/time_left.h"

#include <boost/test/unit_test.hpp>

#include <string>

using namespace planula;

namespace {

const auto nearly = boost::test_tools::tolerance(1e-9);

/// A run that does `evaluations` every `seconds`, `times` times from `now` on, on one thread; the time afterwards.
double compute(TimeLeft &left, const std::string &setting, double evaluations, double seconds, int times,
               double now) {
    left.open(now);
    for (int i = 0; i < times; ++i) left.done(setting, evaluations, seconds, now += seconds);
    left.close(now);
    return now;
}

} // namespace

BOOST_AUTO_TEST_CASE(nothing_is_said_before_enough_is_measured) {
    TimeLeft left;
    BOOST_TEST(left.rate() == 0);
    left.open(0);
    left.done("a", 100, 5, 5);
    left.done("a", 100, 4, 9);
    BOOST_TEST(left.seconds({{"a", 100}}) == 0);
    left.done("a", 100, 3, 12);
    BOOST_TEST(left.rate() > 0);
    BOOST_TEST(left.seconds({{"a", 100}}) > 0);
    BOOST_TEST(left.seconds({}) == 0);
}

BOOST_AUTO_TEST_CASE(each_setting_has_its_own_cost) {
    TimeLeft left;
    const double now = compute(left, "slow", 100, 10, 5, 1000); // the clock begins anywhere
    compute(left, "fast", 100, 1, 5, now);
    BOOST_TEST(left.seconds({{"slow", 1000}}) == 100, nearly);
    BOOST_TEST(left.seconds({{"slow", 1000}, {"fast", 1000}}) == 110, nearly);
    // One that was not seen costs as much as the mean of those that were.
    BOOST_TEST(left.seconds({{"other", 1000}}) == 55, nearly);
}

BOOST_AUTO_TEST_CASE(runs_at_the_same_time_share_the_machine) {
    // Four runs that together do 40 evaluations a second on four threads report one after the other.
    TimeLeft left;
    for (int run = 0; run < 4; ++run) left.open(0);
    for (int generation = 1; generation <= 3; ++generation)
        for (int run = 0; run < 4; ++run) {
            left.done("x", 400, 40, 40.0 * generation);
            if (generation == 1 && run < 3)
                BOOST_TEST(left.seconds({{"x", 4000}}) == 0); // most is not reported yet
        }
    BOOST_TEST(left.seconds({{"x", 4000}}) > 90);
    BOOST_TEST(left.seconds({{"x", 4000}}) < 110);
}

BOOST_AUTO_TEST_CASE(a_run_that_gets_few_threads_is_not_taken_for_a_slow_one) {
    // Two runs of settings that cost the same, on two threads: tasks of the first come first, so that it does nine
    // evaluations while the second does one. 20 evaluations take 10 s.
    TimeLeft left;
    left.open(0), left.open(0);
    double now = 0;
    for (int i = 0; i < 50; ++i) {
        for (int report = 0; report < 9; ++report) left.done("first", 2, 2, now += 1);
        left.done("second", 2, 2, now += 1);
    }
    BOOST_TEST(left.seconds({{"first", 1000}, {"second", 1000}, {"other", 1000}}) == 1500, nearly);
}

BOOST_AUTO_TEST_CASE(a_pause_between_runs_costs_nothing) {
    TimeLeft left;
    compute(left, "a", 100, 10, 3, 0);
    compute(left, "a", 100, 10, 3, 5000);
    BOOST_TEST(left.seconds({{"a", 1000}}) == 100, nearly);
}

BOOST_AUTO_TEST_CASE(one_report_changes_little_and_a_lasting_change_all) {
    TimeLeft left;
    double now = compute(left, "a", 100, 10, 50, 0);
    now = compute(left, "a", 100, 20, 1, now);
    const double after_one = left.seconds({{"a", 1000}});
    BOOST_TEST(after_one > 100);
    BOOST_TEST(after_one < 106);
    compute(left, "a", 100, 20, 100, now);
    const double after_many = left.seconds({{"a", 1000}});
    BOOST_TEST(after_many > 195);
    BOOST_TEST(after_many < 200);
}
