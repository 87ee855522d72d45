// SPDX-License-Identifier: MIT
// What is measured, by the clock (bench.cpp) and in instructions (work.cpp): worlds, bodies, a wave along them, and
// points among which novelty looks for neighbours.
#pragma once

#include "base/random.h"
#include "evaluation/conditions.h"
#include "evolution/nearest_neighbours.h"
#include "network/activations.h"
#include "network/network.h"
#include "physics/engine.h"
#include "physics/soft_body.h"
#include "support/specimens.h"

#include <utility>
#include <vector>

namespace planula::cases {

struct World {
    const char *name;
    Environment environment;
};
inline const World worlds[] = {{"water", specimens::water()}, {"land", specimens::land()}};

struct Size {
    int columns, rows;
    int cells() const { return columns * rows; }
};
inline constexpr Size sizes[] = {{6, 5}, {10, 10}, {20, 10}};

inline Conditions conditions(Actuation actuation, const World &world) {
    Conditions result;
    result.parameters = specimens::turning();
    const Parameters &p = result.parameters;
    result.actuation = actuation;
    result.environment = world.environment;
    result.actuation_range =
        world.environment.has_ground ? p.land.actuation_range_terrestrial : p.water.actuation_range_aquatic;
    return result;
}

/// Extensions of a wave along the body at the knots of ten of its periods.
inline std::vector<std::vector<double>> wave(const SoftBodyModel &model) {
    std::vector<std::vector<double>> knots(100);
    for (std::size_t knot = 0; knot < knots.size(); ++knot)
        for (const Vec2d p : model.positions)
            knots[knot].push_back(
                0.15 * math::sin(0.2 * math::pi * static_cast<double>(knot) + 0.4 * p.x + 0.1 * p.y));
    return knots;
}

/// A body on which the wave runs, step by step.
class Swimmer {
  public:
    Swimmer(Engine &engine, SoftBodyModel model, const Environment &environment)
        : engine_(engine), model_(std::move(model)), knots_(wave(model_)) {
        engine.load(model_, environment);
    }
    Motion step() {
        const auto interval = static_cast<std::size_t>(GaitParameters().knot_interval);
        if (steps_ % interval == 0)
            engine_.actuate(knots_[steps_ / interval % knots_.size()], static_cast<int>(interval));
        ++steps_;
        return engine_.step(0);
    }

  private:
    Engine &engine_;
    const SoftBodyModel model_; // outlives its stay in the engine
    const std::vector<std::vector<double>> knots_;
    std::size_t steps_ = 0;
};

/// A hundred cells with activations of their own.
inline Activations hundred_cells(const Network &network) {
    constexpr int cells = 100;
    Activations activations(network.nodes, cells);
    for (int cell = 0; cell < cells; ++cell)
        for (int node = 0; node < network.nodes; ++node) activations.at(cell, node) = 0.01 * cell;
    return activations;
}

/// Grows to exactly 100 cells, dividing until the last decision.
inline Genome hundred_genome(Actuation actuation) {
    Genome genome = specimens::line_genome(actuation, 19);
    specimens::wire(genome, input::bias, output::division_angle, 0.5);
    specimens::add_muscles(genome, actuation);
    return genome;
}

/// End points of `count` individuals, dense at the start as those of populations are.
inline PointIndex end_points(int count, std::uint64_t seed) {
    PointIndex index;
    Stream stream(seed, 0, 0, Purpose::initial_weights);
    for (int i = 0; i < count; ++i) {
        const double x = stream.triangular(), y = stream.triangular();
        index.add(std::vector{10 * x, 10 * y});
    }
    return index;
}

} // namespace planula::cases
