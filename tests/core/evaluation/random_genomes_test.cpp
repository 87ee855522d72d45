// SPDX-License-Identifier: MIT
// Random and hostile genomes through whole lives; tests/torture/random_genomes.cpp lives more of them.
#include "base/parallel.h"
#include "support/hostile.h"

#include <boost/test/unit_test.hpp>

#include <array>

using namespace planula;
using namespace planula::specimens;

BOOST_AUTO_TEST_CASE(two_thousand_hostile_genomes_end_in_finite_lives_or_a_named_outcome) {
    constexpr int count = 2000;
    std::array<int, outcome_names.size()> ends{};
    std::vector<Life> lives(count);
    const auto conditions_of = [](int number) {
        return short_life(number % 2 ? Actuation::grn : Actuation::oscillator, number / 2 % 2 == 1);
    };
    parallel_for(count, hardware_threads(), [&](int number) {
        const Conditions conditions = conditions_of(number);
        lives[number] =
            live(hostile_genome(conditions.actuation, static_cast<std::uint32_t>(number)), conditions);
    });
    for (int number = 0; number < count; ++number) {
        BOOST_TEST(flaw(lives[number], conditions_of(number).parameters) == "", "genome " << number);
        ++ends[static_cast<std::size_t>(lives[number].outcome)];
    }

    // They are not all alike: most outcomes occur.
    for (std::size_t i = 0; i < ends.size(); ++i) BOOST_TEST_MESSAGE(outcome_names[i] << ' ' << ends[i]);
    for (const Outcome outcome :
         {Outcome::viable, Outcome::died_out, Outcome::too_small, Outcome::overgrown, Outcome::exploded})
        BOOST_TEST(ends[static_cast<std::size_t>(outcome)] > 0, name_of(outcome));
}
