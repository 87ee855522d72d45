// SPDX-License-Identifier: MIT
// The native engine computes what the reference engine says, for bodies that grow from random genomes.
#include "support/lockstep_life.h"

#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::specimens;

BOOST_AUTO_TEST_CASE(each_step_of_a_random_individual_is_that_of_the_reference_engine) {
    Environment hills = land();
    hills.ground = {{-5, 0}, {-1, 0.5}, {0, 0}, {2, -1}, {6, 1}, {30, 2}};
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn})
        for (const auto &[name, environment] :
             {std::pair("water", water()), {"land", land()}, {"hills", hills}}) {
            Conditions conditions{.actuation = actuation, .environment = environment};
            conditions.parameters.gait.locomotion_steps = 1000;
            conditions.parameters.settling.settle_limit = 2000;
            conditions.actuation_range = 0.4;
            Lockstep lockstep;
            int bodies = 0;
            for (std::uint64_t seed = 1; seed <= 60; ++seed)
                bodies += move(random_genome(actuation, seed), conditions, lockstep);
            for (const Genome &genome :
                 {lump_genome(actuation, 6), disc_genome(actuation), two_legged_genome(actuation)})
                bodies += move(genome, conditions, lockstep);
            const auto [velocity, position] = rounding_bound(environment);
            BOOST_TEST_MESSAGE(name_of(actuation)
                               << ", " << name << ": " << bodies << " bodies, " << lockstep.steps
                               << " steps, touching in " << lockstep.touching << ", off by "
                               << lockstep.position_error << " cells and " << lockstep.velocity_error
                               << " cells/t.u.");
            BOOST_TEST(bodies > 10, name);
            BOOST_TEST(lockstep.exploded_alike, name);
            BOOST_TEST(lockstep.position_error < position, name);
            BOOST_TEST(lockstep.velocity_error < velocity, name);
        }
}
