// SPDX-License-Identifier: MIT
// Lives on a device are those on this processor, to the bit, and those that it does not simulate are simulated here.
#include "support/device_lives.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::specimens;
using namespace planula::test;

namespace {

Environment hills() {
    Environment environment = land();
    environment.ground = {{-5, 0}, {-1, 0.5}, {0, 0}, {2, -1}, {6, 1}, {30, 2}};
    return environment;
}

} // namespace

BOOST_AUTO_TEST_CASE(random_individuals_live_on_a_device_as_here) {
    int moved = 0;
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        std::vector<Genome> genomes{lump_genome(actuation, 6), two_legged_genome(actuation)};
        for (std::uint64_t seed = 1; seed <= 30; ++seed) genomes.push_back(random_genome(actuation, seed));
        for (const Environment &environment : {water(), land(), hills()})
            moved += compare_lives(genomes, short_life(actuation, environment));
    }
    BOOST_TEST(moved > 10);
}

BOOST_AUTO_TEST_CASE(lives_that_a_device_does_not_simulate_are_simulated_here) {
    const std::vector<Genome> few{lump_genome(Actuation::oscillator, 6),
                                  random_genome(Actuation::oscillator, 3)};
    Conditions phases = short_life(Actuation::oscillator, water()), observed = phases, held = phases,
               other_engine = phases;
    phases.phases = {{200, land(), 0.3, false}};
    observed.observed.add(Observation::work);
    held.held_from = 100;
    other_engine.engine = "reference";
    for (const Conditions &given : {phases, observed, held, other_engine}) {
        const std::vector<Life> here = lives(few, given);
        const OnDevice device(Order::forward);
        BOOST_TEST((lives(few, given) == here));
        BOOST_TEST(device.trials() == 0);
    }
}
