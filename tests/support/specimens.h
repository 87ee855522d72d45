// SPDX-License-Identifier: MIT
// Genomes and bodies that tests share, made by hand.
#pragma once

#include "base/random.h"
#include "body/body.h"
#include "cell/channels.h"
#include "genome/genome.h"
#include "physics/environment.h"

#include <vector>

namespace planula::specimens {

/// A genome without links: all inputs, all outputs.
inline Genome bare_genome(int inputs, int outputs) {
    Genome genome;
    genome.inputs = inputs, genome.outputs = outputs;
    for (int i = 0; i < inputs; ++i)
        genome.nodes.push_back({i, i + 1 == inputs ? NodeKind::bias : NodeKind::input, 0});
    for (int o = 0; o < outputs; ++o) genome.nodes.push_back({inputs + o, NodeKind::output, 1});
    return genome;
}

inline Genome bare_genome(Actuation actuation) { return bare_genome(input::count, output::count(actuation)); }

inline void add_link(Genome &genome, int from, int to, double weight) {
    genome.links.push_back({static_cast<int>(genome.links.size()), from, to, weight, false});
}

/// A link from an input channel to an output channel.
inline void wire(Genome &genome, input::Channel from, output::Channel to, double weight) {
    add_link(genome, from, genome.inputs + static_cast<int>(to), weight);
}

/// Every input linked to every output with triangular weights, as in generation 0.
inline Genome random_genome(Actuation actuation, std::uint64_t seed) {
    Genome genome = bare_genome(actuation);
    Stream stream(seed, 0, 0, Purpose::initial_weights);
    for (int to = 0; to < genome.outputs; ++to)
        for (int from = 0; from < genome.inputs; ++from)
            add_link(genome, from, genome.inputs + to, stream.triangular());
    return genome;
}

/// Cells never die and stop dividing after `decisions` decisions; all divide eastwards: a line.
inline Genome line_genome(Actuation actuation, int decisions) {
    Genome genome = bare_genome(actuation);
    const double stop = 30.0 * (decisions - 0.5) / 600; // between the last decision to divide and the next
    wire(genome, input::time, output::division_inhibitor, 8);
    wire(genome, input::bias, output::division_inhibitor, -8 * stop);
    wire(genome, input::bias, output::apoptosis, -1);
    return genome;
}

/// Like the line, but the direction of division turns with time and place: a lump. Its period and phase vary
/// over the body, so that it moves.
inline Genome lump_genome(Actuation actuation, int decisions) {
    Genome genome = line_genome(actuation, decisions);
    wire(genome, input::time, output::division_angle, 4);
    wire(genome, input::y, output::division_angle, 2);
    wire(genome, input::x, output::division_angle, -1);
    if (actuation == Actuation::oscillator) {
        wire(genome, input::bias, output::period, -3);
        wire(genome, input::x, output::phase, 6);
        wire(genome, input::y, output::phase, 2);
    } else {
        wire(genome, input::x, output::spring, 2);
        const int spring = genome.inputs + output::spring;
        add_link(genome, spring, spring, -3); // an output that inhibits itself swings between updates
        genome.links.back().recurrent = true;
    }
    return genome;
}

/// Cells on a triangular lattice of unit spacing: `rows` rows of `columns`.
inline Body lattice(int columns, int rows) {
    std::vector<Vec2d> positions;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            positions.push_back({column + 0.5 * (row % 2), row * 0.8660254037844386});
    return make_body(positions, 1.5);
}

inline Environment water() { return {.drag_normal = 1.0, .drag_tangential = 0.1}; }
inline Environment land() { return {.gravity = 5, .has_ground = true, .friction = 0.8}; }
inline Environment empty_space() { return {}; }

} // namespace planula::specimens
