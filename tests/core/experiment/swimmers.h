// SPDX-License-Identifier: MIT
// A small experiment for tests of runs: swimmers judged by how far they come.
#pragma once

#include "experiment/spec.h"
#include "support/specimens.h"

#include <string_view>

namespace planula {

/// Four generations of swimmers.
inline Spec swimmers(std::string_view search, Actuation actuation, int population, int locomotion_steps) {
    Spec spec;
    spec.name = "small";
    spec.actuation = actuation;
    spec.actuation_range = spec.parameters.water.actuation_range_aquatic;
    spec.search = search;
    spec.environment = specimens::water();
    spec.parameters.neat.population = population;
    spec.parameters.design.generations = 4;
    spec.parameters.gait.locomotion_steps = locomotion_steps;
    spec.judge = [](const Life &life) {
        const bool viable = life.outcome == Outcome::viable;
        return Evaluation{life.displacement(), {life.finish.x, life.finish.y}, viable ? 1.0 : 0.0};
    };
    return spec;
}

} // namespace planula
