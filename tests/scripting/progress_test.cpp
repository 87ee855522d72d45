// SPDX-License-Identifier: MIT
#include "scripting/progress.h"

#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <sstream>

#include <unistd.h>

using namespace planula;

BOOST_AUTO_TEST_CASE(durations_are_told_in_two_units) {
    BOOST_TEST(duration_text(0) == "0 s");
    BOOST_TEST(duration_text(59.4) == "59 s");
    BOOST_TEST(duration_text(60) == "1 min 0 s");
    BOOST_TEST(duration_text(3599) == "59 min 59 s");
    BOOST_TEST(duration_text(3661) == "1 h 1 min");
    BOOST_TEST(duration_text(1e300) == duration_text(1e9));
}

BOOST_AUTO_TEST_CASE(a_terminal_gets_one_line_that_is_rewritten_and_cleared) {
    std::ostringstream out;
    {
        Progress progress(out, true, 100);
        progress.begin("a seed 1", 4);
        usleep(250000);
        progress.generation(1, 12.345, 25);
        progress.tell("done");
    }
    BOOST_TEST(test::contains(out.str(), "\r\x1b[Ka seed 1: generation 2 of 4, best 12.3"), out.str());
    BOOST_TEST(test::contains(out.str(), " evaluations/s, "));
    BOOST_TEST(test::contains(out.str(), " left"));
    BOOST_TEST(out.str().ends_with("\r\x1b[Kdone\n"));
}

BOOST_AUTO_TEST_CASE(a_log_is_not_flooded) {
    std::ostringstream out;
    Progress progress(out, false, 1000000);
    progress.begin("a seed 1", 1000);
    for (int i = 0; i < 1000; ++i) progress.generation(i, 1, 1);
    BOOST_TEST(out.str() == "");
}
