// SPDX-License-Identifier: MIT
#include "benchmarks/settings.h"

namespace planula::benchmark {

namespace {

constexpr double slope = 2.45; // of their sigmoid, as a tanh

} // namespace

Settings multineat_settings() {
    Parameters p;
    p.neat.start_weight = p.neat.weight_power = 1;
    p.neat.weight_step = 0;
    return {"multineat", p};
}

Settings stanley_settings(bool large) {
    Parameters p;
    p.neat.population = large ? 1000 : 150;
    p.neat.compatibility_threshold = large ? 4 : 3;
    p.neat.compatibility_step = 0;
    p.neat.weight_coefficient = (large ? 3 : 0.4) / slope;
    p.neat.young_boost = 1;
    p.neat.stagnation_limit = 15;
    p.neat.survival_rate = 0.2;
    p.neat.crossover_rate = 0.75;
    p.neat.multipoint_rate = 0.6;
    p.neat.interspecies_rate = 0.001;
    p.neat.mutation_rate = 0.8;
    p.neat.add_node_rate = large ? 0.01 : 0.03;
    p.neat.add_link_rate = large ? 0.3 : 0.05;
    p.neat.remove_link_rate = 0;
    p.neat.mutate_weights_rate = 0.8;
    p.neat.weight_severe_rate = 0.1;
    p.neat.start_weight = p.neat.weight_power = p.neat.weight_replacement = (large ? 1.8 : 2.5) * slope;
    p.neat.weight_limit = 1000;
    p.neat.weight_step = 0;
    p.neat.recurrent_rate = 0.2;
    p.neat.link_tries = 20;
    return {"stanley-2002", p};
}

Settings lehman_settings() {
    Parameters p;
    p.neat.population = 250;
    p.neat.compatibility_threshold = 4;
    p.neat.compatibility_step = 1;
    p.neat.compatibility_floor = 0.3;
    p.neat.species_low = p.neat.species_high = 16;
    p.neat.weight_coefficient = 3 / slope;
    p.neat.young_boost = 1;
    p.neat.stagnation_limit = 2000;
    p.neat.survival_rate = 0.4;
    p.neat.crossover_rate = 0.7;
    p.neat.multipoint_rate = 0.6;
    p.neat.interspecies_rate = 0.001;
    p.neat.mutation_rate = 0.8;
    p.neat.add_node_rate = 0.005;
    p.neat.add_link_rate = 0.1;
    p.neat.remove_link_rate = 0;
    p.neat.mutate_weights_rate = 0.6;
    p.neat.weight_severe_rate = 0.1;
    p.neat.start_weight = p.neat.weight_power = p.neat.weight_replacement = 0.8 * slope;
    p.neat.weight_limit = 1000;
    p.neat.weight_step = 0;
    p.neat.recurrent_rate = 0.2;
    p.neat.link_tries = 40;
    p.novelty.novelty_neighbours = 15;
    p.novelty.archive_threshold = 6;
    p.novelty.archive_floor = 0.25;
    p.novelty.archive_run = 4;
    p.novelty.archive_raise = 1.2;
    p.novelty.archive_patience = 10;
    p.novelty.archive_lower = 0.95;
    return {"lehman-2011", p};
}

} // namespace planula::benchmark
