// SPDX-License-Identifier: MIT
#include "benchmarks/solve.h"

#include "base/error.h"
#include "benchmarks/settings.h"
#include "benchmarks/xor.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>

using namespace planula;
using namespace planula::benchmark;

namespace {

Parameters few() {
    Parameters parameters;
    parameters.neat.population = 20;
    parameters.neat.start_weight = parameters.neat.weight_power = 1;
    return parameters;
}

/// Solved by the n-th attempt.
Task solved_after(int attempts, int &made) {
    return {"count", {2, 1, false}, [attempts, &made](const Genome &) {
                ++made;
                return Attempt{1, {0}, made == attempts};
            }};
}

} // namespace

BOOST_AUTO_TEST_CASE(attempts_are_counted_up_to_the_first_solution) {
    for (const int attempts : {1, 20, 21, 57}) {
        int made = 0;
        const Solution solution = solve(solved_after(attempts, made), "neat", few(), 1, 10);
        BOOST_TEST(solution.solved);
        BOOST_TEST(solution.evaluations == attempts);
        BOOST_TEST(made == attempts);
        BOOST_TEST(solution.generations == (attempts + 19) / 20);
    }
}

BOOST_AUTO_TEST_CASE(a_run_gives_up_after_its_generations) {
    int made = 0;
    const Solution solution = solve(solved_after(1000, made), "novelty", few(), 1, 3);
    BOOST_TEST(!solution.solved);
    BOOST_TEST(solution.generations == 3);
    BOOST_TEST(solution.evaluations == 60);
}

BOOST_AUTO_TEST_CASE(only_new_champions_are_examined) {
    // Fitness rises in steps, and a champion stays for some generations.
    const auto step_of = [](const Genome &genome) { return std::floor(2 * genome.links[0].weight) + 20; };
    std::vector<double> examined;
    Task task{"examined", {2, 1, false}, [&](const Genome &genome) {
                  return Attempt{step_of(genome), {0}, false};
              }};
    task.examine = [&](const Genome &genome) {
        examined.push_back(step_of(genome));
        return examined.size() == 4;
    };
    const Solution solution = solve(task, "neat", few(), 1, 200);
    BOOST_TEST(solution.solved);
    BOOST_TEST(examined.size() == 4u);
    BOOST_TEST(std::set<double>(examined.begin(), examined.end()).size() == 4u);
    BOOST_TEST(solution.generations > 4);
    BOOST_TEST(solution.evaluations == 20 * solution.generations); // examinations do not count
}

BOOST_AUTO_TEST_CASE(a_run_repeats_and_seeds_differ) {
    const Parameters parameters = stanley_settings(false).parameters;
    std::set<std::int64_t> seen;
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Solution one = solve(xor_task(), "neat", parameters, seed, 100);
        const Solution two = solve(xor_task(), "neat", parameters, seed, 100);
        BOOST_TEST(one.evaluations == two.evaluations);
        seen.insert(one.evaluations);
    }
    BOOST_TEST(seen.size() > 1u);
    BOOST_CHECK_THROW(solve(xor_task(), "none", parameters, 1, 1), InputError);
}

BOOST_AUTO_TEST_CASE(every_setting_is_consistent) {
    for (const Settings &settings :
         {multineat_settings(), stanley_settings(false), stanley_settings(true), lehman_settings()})
        BOOST_CHECK_NO_THROW(check_consistency(settings.parameters));
}
