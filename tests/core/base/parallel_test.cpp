// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include <boost/test/unit_test.hpp>

#include <stdexcept>
#include <string>
#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(every_task_runs_once_for_any_number_of_threads) {
    for (const int threads : {1, 2, 3, 7, 100}) {
        std::vector<int> runs(50, 0);
        parallel_for(50, threads, [&](int i) { ++runs[i]; });
        BOOST_TEST(runs == std::vector<int>(50, 1));
    }
    parallel_for(0, 4, [](int) { BOOST_ERROR("there is no task"); });
}

BOOST_AUTO_TEST_CASE(the_exception_of_the_lowest_task_is_thrown) {
    for (const int threads : {1, 3}) {
        try {
            parallel_for(20, threads, [](int i) {
                if (i >= 5) throw std::runtime_error(std::to_string(i));
            });
            BOOST_ERROR("nothing was thrown");
        } catch (const std::runtime_error &error) {
            BOOST_TEST(error.what() == std::string("5"));
        }
    }
}
