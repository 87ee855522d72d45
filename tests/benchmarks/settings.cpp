// SPDX-License-Identifier: MIT
#include "benchmarks/settings.h"

namespace planula::benchmark {

namespace {

constexpr double slope = 2.45; // of their sigmoid, as a tanh

} // namespace

Settings multineat_settings() {
    Parameters p;
    p.start_weight = p.weight_power = 1;
    p.weight_step = 0;
    return {"multineat", p};
}

Settings stanley_settings(bool large) {
    Parameters p;
    p.population = large ? 1000 : 150;
    p.compatibility_threshold = large ? 4 : 3;
    p.compatibility_step = 0;
    p.weight_coefficient = (large ? 3 : 0.4) / slope;
    p.young_boost = 1;
    p.stagnation_limit = 15;
    p.survival_rate = 0.2;
    p.crossover_rate = 0.75;
    p.multipoint_rate = 0.6;
    p.interspecies_rate = 0.001;
    p.mutation_rate = 0.8;
    p.add_node_rate = large ? 0.01 : 0.03;
    p.add_link_rate = large ? 0.3 : 0.05;
    p.remove_link_rate = 0;
    p.mutate_weights_rate = 0.8;
    p.weight_severe_rate = 0.1;
    p.start_weight = p.weight_power = p.weight_replacement = (large ? 1.8 : 2.5) * slope;
    p.weight_limit = 1000;
    p.weight_step = 0;
    p.recurrent_rate = 0.2;
    p.link_tries = 20;
    return {"stanley-2002", p};
}

Settings lehman_settings() {
    Parameters p;
    p.population = 250;
    p.compatibility_threshold = 4;
    p.compatibility_step = 1;
    p.compatibility_floor = 0.3;
    p.species_low = p.species_high = 16;
    p.weight_coefficient = 3 / slope;
    p.young_boost = 1;
    p.stagnation_limit = 2000;
    p.survival_rate = 0.4;
    p.crossover_rate = 0.7;
    p.multipoint_rate = 0.6;
    p.interspecies_rate = 0.001;
    p.mutation_rate = 0.8;
    p.add_node_rate = 0.005;
    p.add_link_rate = 0.1;
    p.remove_link_rate = 0;
    p.mutate_weights_rate = 0.6;
    p.weight_severe_rate = 0.1;
    p.start_weight = p.weight_power = p.weight_replacement = 0.8 * slope;
    p.weight_limit = 1000;
    p.weight_step = 0;
    p.recurrent_rate = 0.2;
    p.link_tries = 40;
    p.novelty_neighbours = 15;
    p.archive_threshold = 6;
    p.archive_floor = 0.25;
    p.archive_run = 4;
    p.archive_raise = 1.2;
    p.archive_patience = 10;
    p.archive_lower = 0.95;
    return {"lehman-2011", p};
}

} // namespace planula::benchmark
