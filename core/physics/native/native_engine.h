// SPDX-License-Identifier: MIT
// planula's own engine: float state and semi-implicit Euler, ground contact by projected velocities (MODEL
// section 3, B4).
#pragma once

#include "physics/engine.h"
#include "physics/forces.h"
#include "physics/laws/ground.h"

namespace planula {

class NativeEngine : public Engine {
  public:
    void load(const SoftBodyModel &model, const Environment &environment) override;
    Motion step(std::span<const double> rest_lengths, double damping) override;
    std::vector<Vec2d> positions() const override;
    std::vector<Vec2d> velocities() const override;

  private:
    Motion integrate(float damping);
    GroundPlane<float> ground_below(float x) const;

    const SoftBodyModel *model_ = nullptr;
    const Environment *environment_ = nullptr;
    Forces<float> law_;
    std::vector<Vec2f> position_, velocity_, forces_; // per node

    struct Slope {
        float from; // its left end
        GroundPlane<float> plane;
    };
    std::vector<Slope> ground_; // left to right; the first reaches to the left for ever
};

} // namespace planula
