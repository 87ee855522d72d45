// SPDX-License-Identifier: MIT
// The physics seam: an engine moves one soft body through its world, step by step.
#pragma once

#include "physics/environment.h"
#include "physics/soft_body.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace planula {

/// What a step came to.
struct Motion {
    double fastest = 0;    // largest node speed after the step, cells/t.u.
    bool exploded = false; // a node beyond node_speed_limit, or a number that is not finite
};

class Engine {
  public:
    virtual ~Engine() = default;

    /// Takes the body at rest, muscles off. Model and environment must outlive the engine's use of them.
    virtual void load(const SoftBodyModel &model, const Environment &environment) = 0;
    /// Muscles: over the next `steps` steps, >= 1, each node's elongation goes linearly to this one, reached
    /// at the last, and stays there; at first all are 0. They give the springs their rest lengths
    /// (laws/spring.h: actuated_length).
    virtual void actuate(std::span<const double> elongations, int steps) = 0;
    /// One physics step, with an extra damping of all motion (1/t.u.).
    virtual Motion step(double damping) = 0;
    /// Node positions and velocities, world frame.
    virtual std::vector<Vec2d> positions() const = 0;
    virtual std::vector<Vec2d> velocities() const = 0;
};

/// The names that make_engine knows: "native", "bullet".
std::span<const std::string_view> engine_names();
/// Throws InputError with the nearest name if there is no such engine.
std::unique_ptr<Engine> make_engine(std::string_view name);

} // namespace planula
