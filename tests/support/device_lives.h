// SPDX-License-Identifier: MIT
// Lives on an emulated device, compared with those on this processor.
#pragma once

#include "base/parallel.h"
#include "evaluation/live.h"
#include "support/emulated_device.h"

#include <boost/test/unit_test.hpp>

#include <vector>

namespace planula::test {

/// Conditions of lives that are shorter than usual.
inline Conditions short_life(Actuation actuation, const Environment &environment) {
    Conditions result{.actuation = actuation, .actuation_range = 0.35, .environment = environment};
    result.parameters.gait.locomotion_steps = 400;
    result.parameters.settling.settle_limit = 1500;
    result.parameters.settling.settle_window = 200;
    return result;
}

/// On the device that is chosen, if one is.
inline std::vector<Life> lives(const std::vector<Genome> &genomes, const Conditions &given) {
    std::vector<Life> result(genomes.size());
    parallel_for(static_cast<int>(genomes.size()), 4, [&](int i) { result[i] = live(genomes[i], given); });
    return result;
}

/// Demands that these individuals live on an emulated device as here, to the bit. Returns how many of them moved.
inline int compare_lives(const std::vector<Genome> &genomes, const Conditions &given) {
    const std::vector<Life> here = lives(genomes, given);
    const OnDevice device(Order::mixed);
    const std::vector<Life> there = lives(genomes, given);
    int moved = 0;
    for (std::size_t i = 0; i < genomes.size(); ++i) {
        BOOST_TEST((there[i] == here[i]), name_of(given.actuation) << " " << i);
        moved += here[i].displacement() > 0.1;
    }
    BOOST_TEST(device.trials() > 0);
    return moved;
}

} // namespace planula::test
