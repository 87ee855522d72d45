// SPDX-License-Identifier: MIT
#include "physics/reference/reference_engine.h"

#include <algorithm>

namespace planula {

void ReferenceEngine::load(const SoftBodyModel &model, const Environment &environment,
                           const BodyState &state) {
    model_ = &model, environment_ = &environment;
    origin_ = origin_for(state.positions, environment);
    ground_ = lay_ground<double>(environment, origin_);
    walls_ = Walls<double>(environment, origin_);
    rest_lengths_ = reference::RestLengths(model);
    nodes_ = state;
    surroundings_ = environment;
}

void ReferenceEngine::set_flow(Vec2d flow) { surroundings_ = reference::Surroundings(*environment_, flow); }

void ReferenceEngine::actuate(std::span<const double> extensions, int steps) {
    rest_lengths_.actuate(extensions, steps);
}

/// Rule B6: all forces are taken at the start of the step; semi-implicit Euler with the ground in between.
Motion ReferenceEngine::step(double damping) {
    rest_lengths_.advance(); // rule G3
    auto forces = reference::forces_on(*model_, surroundings_, rest_lengths_.now(), nodes_);
    if (!walls_.empty())
        reference::add_pull_of_walls(*model_, walls_.view(), origin_, nodes_.positions, forces);
    accelerate(forces, damping);
    walls_.empty() ? meet_ground() : meet_walls();
    move();
    return reference::motion_of(nodes_.velocities, *model_); // rule B7
}

/// v ← (v + F Δt)(1 − s Δt), and gravity (rule L1).
void ReferenceEngine::accelerate(std::span<const Vec2d> forces, double damping) {
    const double dt = model_->time_step;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        Vec2d &v = nodes_.velocities[i];
        v = (v + forces[i] * dt) * (1 - damping * dt);
        v += surroundings_.fall(nodes_.positions[i]) * dt;
    }
}

/// Rule L3 on level ground; on a polyline what decision 0010 says.
void ReferenceEngine::meet_ground() {
    if (ground_.empty()) return;
    const double dt = model_->time_step, friction = environment_->friction;
    for (std::size_t i = 0; i < nodes_.positions.size(); ++i) {
        const Vec2d x = nodes_.positions[i] - origin_;
        Vec2d &v = nodes_.velocities[i];
        v = ground_.size() == 1 ? ground_contact(x, v, ground_[0].plane, friction, dt)
                                : contact_on_way(ground_, piece_below(ground_, x.x, 0), x, v, friction, dt);
    }
}

/// Decision 0024.
void ReferenceEngine::meet_walls() {
    for (std::size_t i = 0; i < nodes_.positions.size(); ++i) {
        Vec2d &v = nodes_.velocities[i];
        v = contact_with_walls(walls_.view(), nodes_.positions[i] - origin_, v, model_->time_step);
    }
}

/// x ← x + v Δt.
void ReferenceEngine::move() {
    const double dt = model_->time_step;
    for (std::size_t i = 0; i < nodes_.positions.size(); ++i)
        nodes_.positions[i] += nodes_.velocities[i] * dt;
}

Motion reference::motion_of(std::span<const Vec2d> velocities, const SoftBodyModel &model) {
    Motion motion;
    for (const Vec2d v : velocities) {
        const double speed = length(v);
        // NaN counts as over the limit.
        motion.exploded |= !(speed * model.time_step <= model.body.node_speed_limit);
        motion.fastest = std::max(motion.fastest, speed);
    }
    return motion;
}

} // namespace planula
