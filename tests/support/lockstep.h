// SPDX-License-Identifier: MIT
// The native engine beside the reference engine: one step of both from the same state, again and again.
#pragma once

#include "physics/native/native_engine.h"
#include "physics/reference/reference_engine.h"
#include "support/motion.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace planula::specimens {

/// How far a step of the native engine may lead from a step of the reference engine from the same state, by rounding in
/// single precision: the velocity of a node, in cells/t.u., and its place, in cells. Forces of springs, pressure and
/// contact are of the order of 1000; one unit in the last place of that, over a step, is 6e-7 cells/t.u. A place 50
/// cells from the start is known to 4e-6 cells. A polyline holds nodes at heights that are known to 5e-7 cells or less
/// well (laws/ground.h: slack), and a step that corrects such a height changes the velocity by 100 times that.
struct Bound {
    double velocity, position;
};
inline Bound rounding_bound(const Environment &environment) {
    return {environment.ground.empty() ? 5e-5 : 1e-3, 1e-5};
}

/// An engine that moves as the native one. Before each step the reference engine is set to the native state, and after
/// it their nodes are compared.
class Lockstep : public Engine {
  public:
    using Engine::load;
    void load(const SoftBodyModel &model, const Environment &environment, const BodyState &state) override {
        model_ = &model;
        native_.load(model, environment, state), reference_.load(model, environment, state);
    }
    void set_flow(Vec2d flow) override { native_.set_flow(flow), reference_.set_flow(flow); }
    void actuate(std::span<const double> extensions, int interval) override {
        native_.actuate(extensions, interval), reference_.actuate(extensions, interval);
    }
    Motion step(double damping) override {
        reference_.set_nodes({native_.positions(), native_.velocities()});
        touching += is_touching(*model_, native_.positions());
        const Motion motion = native_.step(damping), expected = reference_.step(damping);
        ++steps;
        exploded_alike &= motion.exploded == expected.exploded;
        if (motion.exploded) return motion;
        position_error = std::max(position_error, farthest_apart(positions(), reference_.positions()));
        velocity_error = std::max({velocity_error, farthest_apart(velocities(), reference_.velocities()),
                                   std::abs(motion.fastest - expected.fastest)});
        return motion;
    }
    std::vector<Vec2d> positions() const override { return native_.positions(); }
    std::vector<Vec2d> velocities() const override { return native_.velocities(); }

    // Over all steps so far, of all bodies loaded.
    long steps = 0, touching = 0; // touching: those at which the body touched itself
    double position_error = 0, velocity_error = 0;
    bool exploded_alike = true;

  private:
    const SoftBodyModel *model_ = nullptr;
    NativeEngine native_;
    ReferenceEngine reference_;
};

} // namespace planula::specimens
