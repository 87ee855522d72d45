// SPDX-License-Identifier: MIT
// planula's own engine: float state and semi-implicit Euler, ground contact by projected velocities
// (decision 0008), several nodes at once.
#pragma once

#include "physics/engine.h"
#include "physics/ground.h"
#include "physics/native/contact.h"
#include "physics/native/kernel.h"
#include "physics/surroundings.h"
#include "physics/walls.h"

namespace planula {

class NativeEngine : public Engine {
  public:
    explicit NativeEngine(const native::Kernel &kernel = native::chosen_kernel()) : kernel_(kernel) {}
    NativeEngine(const NativeEngine &) = delete; // its parts point at each other
    NativeEngine &operator=(const NativeEngine &) = delete;

    using Engine::load;
    void load(const SoftBodyModel &model, const Environment &environment, const BodyState &state) override;
    void set_flow(Vec2d flow) override;
    void actuate(std::span<const double> extensions, int steps) override;
    Motion step(double damping) override;
    std::vector<Vec2d> positions() const override;
    std::vector<Vec2d> velocities() const override;

  private:
    void set_tasks(const SoftBodyModel &model);
    void set_gravity();
    void push_outline();

    const native::Kernel &kernel_;
    const Environment *environment_ = nullptr;
    native::Layout body_;
    Vec2d origin_; // that the numbers of nodes and ground count from, world frame
    std::vector<Piece<float>> ground_;
    std::vector<FluidRegion<float>> regions_;
    std::vector<Layer<float>> water_;
    native::Gravity gravity_;
    Walls<float> walls_;      // in place of the ground, if there are some
    float pull_of_walls_ = 0; // on a link, for each cell of depth
    std::vector<int> below_;  // per node, copies included, the number of a piece of ground
    native::StepTask task_;
    native::DragTask drag_;
    native::Contact contact_;

    std::vector<native::Record> now_, next_;
    std::vector<native::Extension> extension_; // per node, copies included
    std::vector<float> push_x_, push_y_;       // the same
    std::vector<native::Force> half_drag_;     // per outline link, and 0 after them
    bool touched_ = false;                     // whether touches or walls pushed
    float moved_ = 0;                          // how far the fastest node went in the last step
    int knot_steps_ = 0, knot_interval_ = 0;
    bool muscles_move_ = false; // towards the coming knot
};

} // namespace planula
