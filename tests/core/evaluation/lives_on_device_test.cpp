// SPDX-License-Identifier: MIT
// Lives on a device are those on this processor, to the bit, and those that it does not simulate are simulated here.
#include "evaluation/live.h"
#include "support/emulated_device.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::specimens;
using planula::test::OnDevice;
using planula::test::Order;

namespace {

Environment hills() {
    Environment environment = land();
    environment.ground = {{-5, 0}, {-1, 0.5}, {0, 0}, {2, -1}, {6, 1}, {30, 2}};
    return environment;
}

Conditions conditions(Actuation actuation, const Environment &environment) {
    Conditions result{.actuation = actuation, .actuation_range = 0.35, .environment = environment};
    result.parameters.gait.locomotion_steps = 400;
    result.parameters.settling.settle_limit = 1500;
    result.parameters.settling.settle_window = 200;
    return result;
}

std::vector<Life> lives(const std::vector<Genome> &genomes, const Conditions &given) {
    std::vector<Life> result;
    for (const Genome &genome : genomes) result.push_back(live(genome, given));
    return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(random_individuals_live_on_a_device_as_here) {
    int moved = 0;
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        std::vector<Genome> genomes{lump_genome(actuation, 6), two_legged_genome(actuation)};
        for (std::uint64_t seed = 1; seed <= 30; ++seed) genomes.push_back(random_genome(actuation, seed));
        for (const Environment &environment : {water(), land(), hills()}) {
            const Conditions given = conditions(actuation, environment);
            const std::vector<Life> here = lives(genomes, given);
            const OnDevice device(Order::mixed);
            const std::vector<Life> there = lives(genomes, given);
            for (std::size_t i = 0; i < genomes.size(); ++i) {
                BOOST_TEST((there[i] == here[i]), name_of(actuation) << " " << i);
                moved += here[i].displacement() > 0.1;
            }
            BOOST_TEST(device.trials() > 0);
        }
    }
    BOOST_TEST(moved > 10);
}

BOOST_AUTO_TEST_CASE(lives_that_a_device_does_not_simulate_are_simulated_here) {
    const std::vector<Genome> few{lump_genome(Actuation::oscillator, 6),
                                  random_genome(Actuation::oscillator, 3)};
    Conditions phases = conditions(Actuation::oscillator, water()), observed = phases, held = phases,
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
