// SPDX-License-Identifier: MIT
// Genomes that no evolution would make, and what must still hold of their lives.
#pragma once

#include "evaluation/live.h"
#include "support/specimens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace planula::specimens {

/// Normal with standard deviation 1, nearly: the sum of twelve uniform draws.
inline double normal(Stream &stream) {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += stream.uniform();
    return sum;
}

/// Every input linked to every output and to up to three hidden nodes, and these to the outputs; loops and
/// links between all outputs in the GRN. Weights are normal; in half of the genomes one in fifty is ±1e300,
/// infinite or no number. In half of them a bias keeps the cells from dying at once.
inline Genome hostile_genome(Actuation actuation, std::uint32_t number) {
    Stream stream(1, is_recurrent(actuation), number, Purpose::sampling);
    Genome genome = bare_genome(actuation);
    const int hidden = static_cast<int>(stream.below(4)), sources = genome.inputs;
    const int outputs = genome.outputs, first_hidden = sources + outputs;
    for (int i = 0; i < hidden; ++i) genome.nodes.push_back({first_hidden + i, NodeKind::hidden, 0.5});

    const double scale = 1 + 4 * stream.uniform();
    const bool is_hostile = stream.chance(0.5);
    const auto weight = [&] {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        constexpr double values[] = {1e300, -1e300, infinity, -infinity,
                                     std::numeric_limits<double>::quiet_NaN()};
        const double plain = scale * normal(stream);
        return is_hostile && stream.chance(0.02) ? values[stream.below(5)] : plain;
    };
    for (int from = 0; from < sources; ++from)
        for (int to = sources; to < first_hidden + hidden; ++to) add_link(genome, from, to, weight());
    for (int from = first_hidden; from < first_hidden + hidden; ++from)
        for (int to = sources; to < first_hidden; ++to) add_link(genome, from, to, weight());
    if (stream.chance(0.5))
        for (LinkGene &link : genome.links)
            if (link.from == input::bias && link.to == sources + output::apoptosis) link.weight -= 3 * scale;
    if (!is_recurrent(actuation)) return genome;
    for (int from = sources; from < first_hidden + hidden; ++from)
        for (int to = sources; to < first_hidden; ++to)
            if (!genome.has_link(from, to)) {
                add_link(genome, from, to, weight());
                genome.links.back().recurrent = true;
            }
    return genome;
}

/// One of the four combinations of actuation and world, with locomotion cut short.
inline Conditions short_life(int combination) {
    Conditions c;
    Parameters &p = c.parameters;
    const bool on_land = combination % 2 == 1;
    c.actuation = combination / 2 % 2 == 0 ? Actuation::oscillator : Actuation::grn;
    c.environment = on_land ? land() : water();
    c.actuation_range = on_land ? p.land.actuation_range_terrestrial : p.water.actuation_range_aquatic;
    p.gait.locomotion_steps = 200, p.gait.ramp_steps = 50, p.settling.settle_limit = 800,
    p.settling.settle_window = 50;
    return c;
}

/// What is wrong with a life, in words; "" if it is finite and ended in a named outcome.
inline std::string flaw(const Life &life, const Parameters &p) {
    const auto outcome = static_cast<std::size_t>(life.outcome);
    if (outcome >= outcome_names.size()) return "an outcome without a name";
    if (!is_finite(life.rest) || !is_finite(life.finish)) return "a place that is not finite";
    for (const Vec2d place : life.path)
        if (!is_finite(place)) return "a path that is not finite";
    if (!std::isfinite(life.elongation) || life.elongation < 0)
        return "an elongation that is not finite or negative";
    if (!(life.activity >= 0 && life.activity <= 1)) return "an activity outside [0, 1]";
    if (!(life.late_actuation >= 0 && life.late_actuation <= 1)) return "a late actuation outside [0, 1]";
    if (life.births < 1 || life.births > p.development.birth_limit)
        return "a count of births beyond its limit";
    if (life.cells < 0 || life.largest < life.cells || life.largest > p.development.cell_limit)
        return "a count of cells beyond its limit";
    const bool is_viable = life.outcome == Outcome::viable;
    if (is_viable && (life.cells < p.development.minimum_cells || life.largest >= p.development.cell_limit))
        return "a viable misfit";
    if (!is_viable && (life.displacement() != 0 || !life.path.empty())) return "a journey without a life";
    return "";
}

} // namespace planula::specimens
