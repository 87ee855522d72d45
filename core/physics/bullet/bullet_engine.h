// SPDX-License-Identifier: MIT
// An independent check: the same soft body in the Bullet Physics Library, as the paper did it (§2.5).
// Nodes are rigid spheres of mass 1 confined to the plane, moved by Bullet's own integrator, ground contact
// and friction; the forces between them are those of the reference engine. It repeats bit for bit on one
// machine; Bullet is not built under the compiler contract, so it stays out of signatures.
#pragma once

#include "physics/engine.h"

#include <memory>

namespace planula {

class BulletEngine : public Engine {
  public:
    BulletEngine();
    ~BulletEngine() override;

    using Engine::load;
    void load(const SoftBodyModel &model, const Environment &environment, const BodyState &state) override;
    void set_flow(Vec2d flow) override;
    void actuate(std::span<const double> extensions, int steps) override;
    Motion step(double damping) override;
    std::vector<Vec2d> positions() const override;
    std::vector<Vec2d> velocities() const override;

  private:
    class World;
    std::unique_ptr<World> world_;
};

} // namespace planula
