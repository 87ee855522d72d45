// SPDX-License-Identifier: MIT
#include "evolution/population.h"

#include "base/check.h"
#include "base/random.h"
#include "evolution/species.h"
#include "genome/mutate.h"

#include <utility>

namespace planula {

namespace {

/// Inputs, the bias and outputs, every input linked to every output; all weights 0.
Genome fully_connected(const NetworkShape &shape, Innovations &innovations) {
    Genome genome;
    genome.inputs = shape.inputs;
    genome.outputs = shape.outputs;
    genome.nodes = terminal_nodes(shape.inputs, shape.outputs);
    for (int to = shape.inputs; to < shape.inputs + shape.outputs; ++to)
        for (int from = 0; from < shape.inputs; ++from)
            genome.links.push_back({innovations.link(from, to), from, to, 0, false});
    return genome;
}

} // namespace

Population initial_population(const NetworkShape &shape, const NeatParameters &parameters,
                              std::uint64_t seed) {
    CHECK(shape.inputs >= 1 && shape.outputs >= 1, shape.inputs, shape.outputs);
    Population population;
    population.threshold = parameters.compatibility_threshold;
    population.innovations = Innovations(shape.inputs + shape.outputs);
    const Genome ancestor = fully_connected(shape, population.innovations);
    for (int slot = 0; slot < parameters.population; ++slot) {
        Stream stream(seed, 0, slot, Purpose::initial_weights);
        Genome child = ancestor;
        for (auto &link : child.links) link.weight = new_weight(parameters.start_weight, parameters, stream);
        add_child(parameters, population, std::move(child));
    }
    complete_generation(parameters.population, population);
    return population;
}

} // namespace planula
