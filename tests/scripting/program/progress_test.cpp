// SPDX-License-Identifier: MIT
#include "program/progress.h"

#include "base/parallel.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

using namespace planula;

namespace {

GenerationReport report(const std::string &run, int number, int generations, double best, int evaluations) {
    return {.setting = "a",
            .run = run,
            .number = number,
            .generations = generations,
            .best = best,
            .unit = "cells",
            .viable = 0.755,
            .evaluations = evaluations};
}

} // namespace

BOOST_AUTO_TEST_CASE(durations_have_two_units) {
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
        Progress progress(out, true, {{"a", 100}});
        const Progress::Open first(progress);
        usleep(250000);
        progress.generation(report("a seed 1", 1, 4, 12.345, 25));
        progress.tell("done");
    }
    BOOST_TEST(
        test::contains(
            out.str(),
            "\r\x1b[Ka seed 1: generation 2 of 4, best 12.35 cells, 76 % viable; time left not known yet"),
        out.str());
    BOOST_TEST(out.str().ends_with("\r\x1b[Kdone\n"));
}

BOOST_AUTO_TEST_CASE(progress_is_shared_from_the_beginning_of_each_level) {
    std::ostringstream out;
    std::vector<Standing> shared;
    {
        Progress progress(out, false, {{"a", 100}},
                          [&](const Standing &standing) { shared.push_back(standing); });
        progress.begin_level(5, 1, 4, 1, {{"a", 60}}, {{"a", 100}});
        progress.generation(report("a seed 1", 0, 5, 1, 20));
        progress.reach();
        progress.generation(report("a seed 2", 0, 5, 1, 30));
        progress.begin_level(9, 0, 4, 0, {{"a", 40}}, {{"a", 40}});
    }
    BOOST_REQUIRE_EQUAL(shared.size(), 2u);
    BOOST_TEST(shared[0].level == 5);
    BOOST_TEST(shared[0].levels_left == 1);
    BOOST_TEST(shared[0].runs == 4);
    BOOST_TEST(shared[0].runs_done == 1);
    BOOST_TEST(shared[0].rate == 0);
    BOOST_TEST(shared[1].level == 9);
    BOOST_TEST(shared[1].levels_left == 0);
    BOOST_TEST(shared[1].runs_done == 0);
    BOOST_TEST(shared[1].evaluations == 50);
    BOOST_TEST(shared[1].rate == 0); // that is not known within a few seconds
}

BOOST_AUTO_TEST_CASE(the_rewritten_line_includes_all_runs_and_levels) {
    std::ostringstream out;
    Progress progress(out, true, {{"a", 100}});
    progress.begin_level(25, 2, 8, 3, {{"a", 50}}, {{"a", 100}});
    usleep(250000);
    progress.generation(report("a seed 1", 1, 25, 1, 25));
    BOOST_TEST(test::contains(out.str(), "; 3 of 8 runs done, level 25; "), out.str());
}

BOOST_AUTO_TEST_CASE(a_log_gets_few_lines_of_progress) {
    std::ostringstream out;
    Progress progress(out, false, {{"a", 1000000}});
    for (int i = 0; i < 1000; ++i) progress.generation(report("a seed 1", i, 1000, 1, 1));
    BOOST_TEST(out.str() == "");
}

BOOST_AUTO_TEST_CASE(several_runs_print_whole_lines) {
    std::ostringstream out;
    {
        Progress progress(out, true, {{"a", 100}});
        const Progress::Open first(progress), second(progress);
        usleep(250000);
        progress.generation(report("b seed 2", 0, 4, 1, 25));
        parallel_for(50, 4, [&](int i) { progress.tell("<" + std::to_string(i % 10) + " is done>"); });
    }
    BOOST_TEST(test::contains(out.str(),
                              "b seed 2: generation 1 of 4, best 1.00 cells, 76 % viable (2 runs at once); "),
               out.str());
    std::istringstream lines(out.str());
    int told = 0;
    for (std::string line; std::getline(lines, line); ++told) BOOST_TEST(line.ends_with(" is done>"), line);
    BOOST_TEST(told == 50);
}
