// SPDX-License-Identifier: MIT
// planula's own engine: float state, semi-implicit Euler, one pass per force family (MODEL section 3, B4).
// Every sum is made in the order of links, triangles and outline, so the result depends on the body alone.
#pragma once

#include "physics/engine.h"
#include "physics/laws/ground.h"
#include "physics/native/self_contact.h"

namespace planula {

class NativeEngine : public Engine {
  public:
    void load(const SoftBodyModel &model, const Environment &environment) override;
    Motion step(std::span<const double> rest_lengths, double damping) override;
    std::vector<Vec2d> positions() const override;
    std::vector<Vec2d> velocities() const override;

    /// Force families, each adding to `forces` at the present state; for tests of one law at a time.
    void add_spring_forces(std::span<const double> rest_lengths);
    void add_pressure_forces();
    void add_drag_forces();
    void add_contact_forces();
    std::vector<Vec2f> forces; // per node

  private:
    Motion integrate(float damping);
    GroundPlane<float> ground_below(float x) const;

    const SoftBodyModel *model_ = nullptr;
    const Environment *environment_ = nullptr;
    std::vector<Vec2f> position_, velocity_;
    std::vector<float> area_, pressure_stiffness_; // per triangle
    SelfContact contact_;

    struct Slope {
        float from; // its left end
        GroundPlane<float> plane;
    };
    std::vector<Slope> ground_; // left to right; the first reaches to the left for ever
};

} // namespace planula
