// SPDX-License-Identifier: MIT
// Evolved individuals live on a device as on this processor, to the bit, with both actuations, in water and on land.
#include "base/parallel.h"
#include "evaluation/live.h"
#include "statement/specimens.h"
#include "support/emulated_device.h"
#include "support/scripts.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

namespace {

Conditions conditions(Actuation actuation, const Environment &environment) {
    Conditions result{.actuation = actuation, .actuation_range = 0.35, .environment = environment};
    result.parameters.gait.locomotion_steps = 400;
    result.parameters.settling.settle_limit = 1500;
    result.parameters.settling.settle_window = 200;
    return result;
}

std::vector<Life> lives(const std::vector<Genome> &genomes, const Conditions &given) {
    std::vector<Life> result(genomes.size());
    parallel_for(static_cast<int>(genomes.size()), 4, [&](int i) { result[i] = live(genomes[i], given); });
    return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(evolved_individuals_live_on_a_device_as_here) {
    int moved = 0;
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        const std::vector<Genome> genomes = specimens(experiments_folder(), actuation);
        for (const Environment &environment :
             {Environment{.drag_normal = 1.0, .drag_tangential = 0.1},
              Environment{.gravity = 5, .has_ground = true, .friction = 0.8}}) {
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
