// SPDX-License-Identifier: MIT
// The interface of the physics engines: an engine moves one soft body through its world, step by step.
#pragma once

#include "physics/environment.h"
#include "physics/soft_body.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace planula {

/// What a step came to (rule B7).
struct Motion {
    double fastest = 0;    // largest node speed after the step, cells/t.u.
    bool exploded = false; // a node beyond node_speed_limit, or a number that is not finite
};

class Engine {
  public:
    virtual ~Engine() = default;

    /// Takes the body in this state, muscles off. Model and environment must outlive the engine's use of them.
    virtual void load(const SoftBodyModel &model, const Environment &environment, const BodyState &state) = 0;
    /// Takes the body at rest where the model has it.
    void load(const SoftBodyModel &model, const Environment &environment) {
        load(model, environment, at_rest(model));
    }
    /// From now on the fluid flows so where no region has a flow of its own; at first as it does at step 0.
    virtual void set_flow(Vec2d flow) = 0;
    /// Muscles: over the next `steps` steps, >= 1, the rest length of each spring goes linearly to the one that these
    /// extensions of its two nodes give (laws/spring.h: actuated_length). It is reached at the last of these steps and
    /// stays there. At first all extensions are 0.
    virtual void actuate(std::span<const double> extensions, int steps) = 0;
    /// One physics step, with an extra damping of all motion (1/t.u.).
    virtual Motion step(double damping) = 0;
    /// Node positions and velocities, world frame.
    virtual std::vector<Vec2d> positions() const = 0;
    virtual std::vector<Vec2d> velocities() const = 0;
};

/// The names that make_engine knows: "native", "reference", "bullet".
std::span<const std::string_view> engine_names();
/// Throws InputError with the nearest name if there is no such engine.
std::unique_ptr<Engine> make_engine(std::string_view name);

} // namespace planula
