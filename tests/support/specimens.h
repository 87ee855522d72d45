// SPDX-License-Identifier: MIT
// Genomes and bodies that tests share, made by hand.
#pragma once

#include "base/math.h"
#include "base/random.h"
#include "body/body.h"
#include "cell/channels.h"
#include "genome/genome.h"
#include "parameters/parameters.h"
#include "physics/embody.h"
#include "physics/environment.h"

#include <algorithm>
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

/// The reading under which these genomes grow what their names say: mother and daughter turn, by up to half a turn.
inline Parameters turning(Parameters parameters = {}) {
    parameters.development.division_turn = DivisionTurn::both;
    parameters.development.orientation_frame = OrientationFrame::plane;
    parameters.development.division_angle_range = 1;
    return parameters;
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

/// Period and phase, or the spring signal, vary over the body, so that it moves.
inline void add_muscles(Genome &genome, Actuation actuation) {
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
}

/// Like the line, but the direction of division turns with time and place: a lump that moves.
inline Genome lump_genome(Actuation actuation, int decisions) {
    Genome genome = line_genome(actuation, decisions);
    wire(genome, input::time, output::division_angle, 4);
    wire(genome, input::y, output::division_angle, 2);
    wire(genome, input::x, output::division_angle, -1);
    add_muscles(genome, actuation);
    return genome;
}

/// All cells divide in one direction, which turns by 44 degrees from decision to decision: a disc that moves, of
/// 60 cells after 14 decisions.
inline Genome disc_genome(Actuation actuation, int decisions = 14) {
    Genome genome = line_genome(actuation, decisions);
    wire(genome, input::bias, output::division_angle, 0.25);
    add_muscles(genome, actuation);
    return genome;
}

/// A hidden node that is 1 where `weight` · channel + `offset` is well above 0 and -1 well below.
inline int add_switch(Genome &genome, input::Channel channel, double weight, double offset) {
    const int node = genome.nodes.back().id + 1;
    genome.nodes.push_back({node, NodeKind::hidden, 0.5});
    add_link(genome, channel, node, weight);
    add_link(genome, input::bias, node, offset);
    return node;
}

/// A disc of 80 cells in whose southern half, after the last division, the cells with |x| < 1.6 die: 63 cells
/// on two legs.
inline Genome two_legged_genome(Actuation actuation) {
    Genome genome = line_genome(actuation, 18);
    wire(genome, input::bias, output::division_angle, 0.25);
    const std::vector<int> conditions{
        add_switch(genome, input::x, 40, 6.4), add_switch(genome, input::x, -40, 6.4),
        add_switch(genome, input::y, -40, 0), add_switch(genome, input::time, 40, -40 * 0.87)};
    // All four at once: their sum must exceed 3, by the line's own weight of -1.
    for (const int node : conditions) add_link(genome, node, genome.inputs + output::apoptosis, 1.0 / 3);
    add_muscles(genome, actuation);
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

/// Cells in rows across a curve, 0.9 apart and centred on it: a ribbon `width` cells wide.
inline Body ribbon(const std::vector<Vec2d> &curve, int width) {
    std::vector<Vec2d> positions;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const Vec2d tangent = curve[std::min(i + 1, curve.size() - 1)] - curve[i == 0 ? 0 : i - 1];
        const Vec2d across = right_normal(tangent) / length(tangent);
        for (int row = 0; row < width; ++row)
            positions.push_back(curve[i] + across * (0.9 * (row - 0.5 * (width - 1))));
    }
    return make_body(positions, 1.5);
}

/// A U, open to the north: two arms of ten cells, the centre lines `span` apart, joined by half a circle.
inline Body u_body(int width, double span = 4) {
    std::vector<Vec2d> curve;
    const int bend = static_cast<int>(math::pi * span / 2 + 0.5);
    for (int i = 10; i > 0; --i) curve.push_back({-span / 2, static_cast<double>(i)});
    for (int i = 0; i <= bend; ++i) {
        const double angle = math::pi * (1 + static_cast<double>(i) / bend);
        curve.push_back({span / 2 * math::cos(angle), span / 2 * math::sin(angle)});
    }
    for (int i = 1; i <= 10; ++i) curve.push_back({span / 2, static_cast<double>(i)});
    return ribbon(curve, width);
}

/// Two turns of a spiral, 1.7 cells free between them if it is two cells wide.
inline Body spiral_body(int width) {
    std::vector<Vec2d> curve;
    for (double angle = 0, r = 2; angle < 4 * math::pi; angle += 1 / r) {
        r = 2 + 2.6 * angle / (2 * math::pi);
        curve.push_back({r * math::cos(angle), r * math::sin(angle)});
    }
    return ribbon(curve, width);
}

/// Two upright arms `width` columns wide and twelve cells long on a base three cells deep, on a triangular
/// lattice; two columns are free between them.
inline Body two_arms(int width) {
    std::vector<Vec2d> positions;
    for (int column = 0; column < 2 * width + 2; ++column) {
        const bool arm = column < width || column >= width + 2;
        for (int row = 0; row < (arm ? 12 : 3); ++row)
            positions.push_back({column * 0.8660254037844386, row + 0.5 * (column % 2)});
    }
    return make_body(positions, 1.5);
}

/// A ring with a gap, two cells wide.
inline Body hook() {
    std::vector<Vec2d> positions;
    for (int i = 0; i <= 12; ++i) {
        const double angle = i * 0.42;
        for (const double r : {2.4, 3.3}) positions.push_back({r * math::cos(angle), r * math::sin(angle)});
    }
    return make_body(positions, 1.5);
}

inline Environment water() { return {.drag_normal = 1.0, .drag_tangential = 0.1}; }
inline Environment land() { return {.gravity = 5, .has_ground = true, .friction = 0.8}; }
inline Environment empty_space() { return {}; }

/// The body in its world, with these numbers of the laws.
inline SoftBodyModel soft_body(const Body &body, const Environment &environment, const Parameters &p = {}) {
    return embody(body, environment, p.body, p.development.time_step);
}

} // namespace planula::specimens
