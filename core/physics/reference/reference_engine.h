// SPDX-License-Identifier: MIT
// The reference engine: the article's rules as they are written, in double precision, one node, spring, triangle and
// pair after another (decision 0021). It is there to be read, and to say what the fast engine must compute.
#pragma once

#include "physics/engine.h"
#include "physics/ground.h"
#include "physics/reference/forces.h"
#include "physics/reference/rest_lengths.h"
#include "physics/walls.h"

namespace planula {

class ReferenceEngine : public Engine {
  public:
    using Engine::load;
    void load(const SoftBodyModel &model, const Environment &environment, const BodyState &state) override;
    void set_flow(Vec2d flow) override;
    void actuate(std::span<const double> extensions, int steps) override;
    Motion step(double damping) override;
    std::vector<Vec2d> positions() const override { return nodes_.positions; }
    std::vector<Vec2d> velocities() const override { return nodes_.velocities; }

    /// Goes on from other places and velocities of the nodes; the muscles stay as they are.
    void set_nodes(reference::Nodes nodes) { nodes_ = std::move(nodes); }

  private:
    void accelerate(std::span<const Vec2d> forces, double damping);
    void meet_ground();
    void meet_walls();
    void move();

    const SoftBodyModel *model_ = nullptr;
    const Environment *environment_ = nullptr;
    Vec2d origin_; // that the ground counts from, world frame
    std::vector<Piece<double>> ground_;
    reference::Surroundings surroundings_;
    Walls<double> walls_; // in place of the ground, if there are some
    reference::RestLengths rest_lengths_;
    reference::Nodes nodes_;
};

namespace reference {

/// What a step that left nodes with these velocities came to (rule B7).
Motion motion_of(std::span<const Vec2d> velocities, const SoftBodyModel &model);

} // namespace reference

} // namespace planula
