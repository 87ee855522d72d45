// SPDX-License-Identifier: MIT
// Random and hostile genomes through whole lives; tests/torture/random_genomes.cpp lives more of them.
#include "base/parallel.h"
#include "support/hostile.h"

#include <boost/test/unit_test.hpp>

#include <array>

using namespace planula;
using namespace planula::specimens;

BOOST_AUTO_TEST_CASE(two_thousand_hostile_genomes_end_in_finite_lives_or_a_named_outcome) {
    // Each in all four combinations of actuation and world.
    constexpr int count = 4 * 2000;
    std::array<int, outcome_names.size()> ends{};
    std::vector<Life> lives(count);
    parallel_for(count, hardware_threads(), [&](int i) {
        const Conditions conditions = short_life(i % 4);
        const Genome genome = hostile_genome(conditions.actuation, static_cast<std::uint32_t>(i / 4));
        lives[i] = live(genome, conditions);
    });
    for (int i = 0; i < count; ++i) {
        BOOST_TEST(flaw(lives[i], short_life(i % 4).parameters) == "", "genome " << i / 4);
        ++ends[static_cast<std::size_t>(lives[i].outcome)];
    }

    // Every outcome occurs.
    for (std::size_t i = 0; i < ends.size(); ++i) BOOST_TEST_MESSAGE(outcome_names[i] << ' ' << ends[i]);
    for (std::size_t i = 0; i < ends.size(); ++i) BOOST_TEST(ends[i] > 0, outcome_names[i]);
}
