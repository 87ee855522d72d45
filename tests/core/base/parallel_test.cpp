// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include <boost/test/unit_test.hpp>

#include <atomic>
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

BOOST_AUTO_TEST_CASE(jobs_of_a_crew_share_their_tasks_and_all_are_done) {
    for (const int threads : {1, 2, 5}) {
        Crew crew(threads);
        std::vector<std::vector<int>> runs(6, std::vector<int>(20, 0));
        crew.work(6, [&](int job) {
            for (int round = 1; round <= 3; ++round) {
                crew.share(job, 20, [&](int i) { ++runs[job][i]; });
                BOOST_REQUIRE(runs[job] == std::vector<int>(20, round)); // a round ends before the next
            }
        });
        for (const auto &job : runs) BOOST_TEST(job == std::vector<int>(20, 3));
    }
}

BOOST_AUTO_TEST_CASE(a_job_alone_leaves_the_other_threads_to_the_next) {
    // The first job waits, outside any task, until the second has begun.
    Crew crew(2);
    std::atomic<bool> second_began{false};
    crew.work(2, [&](int job) {
        crew.share(job, 3, [](int) {});
        if (job == 1) second_began = true;
        while (!second_began) std::atomic_thread_fence(std::memory_order_seq_cst);
    });
    BOOST_TEST(second_began.load());
}

BOOST_AUTO_TEST_CASE(a_thread_that_waits_for_its_own_tasks_does_those_of_others) {
    // The last task of the first job ends when the second job has done three: by the first job's thread.
    Crew crew(2);
    std::atomic<int> done{0};
    crew.work(2, [&](int job) {
        if (job == 0)
            crew.share(job, 2, [&](int i) {
                while (i == 1 && done < 3) std::atomic_thread_fence(std::memory_order_seq_cst);
            });
        else
            crew.share(job, 3, [&](int) { ++done; });
    });
    BOOST_TEST(done == 3);
}

BOOST_AUTO_TEST_CASE(the_first_job_that_throws_ends_the_work_and_is_reported) {
    for (const int threads : {1, 2, 4}) {
        Crew crew(threads);
        int begun = 0;
        const auto job = [&](int number) {
            ++begun;
            if (number == 1) throw std::runtime_error("the second");
            if (threads == 1) return;
            // The others go on in rounds until they learn of it.
            while (!crew.failed()) crew.share(number, 1, [](int) {});
            throw std::runtime_error("told to end");
        };
        try {
            crew.work(threads == 1 ? 3 : 2, job);
            BOOST_ERROR("nothing was thrown");
        } catch (const std::runtime_error &error) {
            BOOST_TEST(error.what() == std::string("the second"));
        }
        BOOST_TEST(begun == 2);
    }
}

BOOST_AUTO_TEST_CASE(what_is_called_around_tasks_is_called_once_for_each_task_of_its_job) {
    Crew crew(3);
    std::atomic<int> around[2] = {0, 0}, done[2] = {0, 0};
    crew.work(2, [&](int job) {
        const Workers workers(crew, job, [&](const std::function<void()> &task) {
            task();
            ++around[job];
        });
        for (int call = 0; call < 4; ++call) workers.each(25, [&](int) { ++done[job]; });
    });
    for (const int job : {0, 1}) {
        BOOST_TEST(around[job] == 100);
        BOOST_TEST(done[job] == 100);
    }
}
