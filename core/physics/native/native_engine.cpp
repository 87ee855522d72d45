// SPDX-License-Identifier: MIT
#include "physics/native/native_engine.h"

#include <algorithm>
#include <cmath>

namespace planula {

void NativeEngine::load(const SoftBodyModel &model, const Environment &environment, const BodyState &state) {
    environment_ = &environment;
    body_ = native::lay_out(model);
    contact_.load(body_, kernel_);
    origin_ = origin_for(state.positions, environment);
    ground_ = lay_ground<float>(environment, origin_);
    walls_ = Walls<float>(environment, origin_);
    pull_of_walls_ = static_cast<float>(model.body.contact_stiffness);

    now_.clear();
    for (const int cell : body_.cell_of) {
        const auto place = rounded_to<float>(state.positions[cell] - origin_);
        const auto velocity = rounded_to<float>(state.velocities[cell]);
        now_.push_back({place.x, place.y, velocity.x, velocity.y});
    }
    next_ = now_;
    below_.assign(now_.size(), 0);
    extension_.assign(now_.size(), {});
    push_x_.assign(now_.size(), 0), push_y_.assign(now_.size(), 0);
    half_drag_.assign(body_.outline.size() * native::group_size + 1, {});
    touched_ = false, moved_ = 0;
    knot_steps_ = knot_interval_ = 0, muscles_move_ = false;
    set_tasks(model);
}

/// The numbers of the laws, and the arrays that the kernel works on.
void NativeEngine::set_tasks(const SoftBodyModel &model) {
    task_ = native::step_task(model, *environment_);
    task_.pairs = body_.pairs.data(), task_.groups = body_.groups, task_.slots = body_.slots.data();
    task_.push_x = push_x_.data(), task_.push_y = push_y_.data();
    task_.ground = ground_.data(), task_.below = below_.data();
    task_.pieces = walls_.empty() ? static_cast<int>(ground_.size()) : native::walls;
    task_.wall_grid = walls_.view();
    set_gravity();
    drag_ = native::drag_task(*environment_);
    drag_.outline = body_.outline.data();
    drag_.group_count = environment_->has_fluid() ? static_cast<int>(body_.outline.size()) : 0;
    drag_.links_at = body_.links_at.data();
    drag_.node_groups = body_.outline_groups(), drag_.links_per_node = body_.links_per_node;
    set_flow(environment_->flow_at(0));
}

/// Gravity that is not the same straight down everywhere.
void NativeEngine::set_gravity() {
    water_ = lay_water<float>(*environment_, origin_);
    if (water_.empty() && environment_->gravity_direction == 0) return;
    const Vec2d fall = gravity_vector(environment_->gravity, environment_->gravity_direction);
    gravity_ = {static_cast<float>(fall.x) * task_.time_step, static_cast<float>(fall.y) * task_.time_step,
                water_.data(), static_cast<int>(water_.size())};
    task_.gravity = &gravity_;
}

void NativeEngine::set_flow(Vec2d flow) {
    const auto rounded = rounded_to<float>(flow);
    drag_.flow_x = rounded.x, drag_.flow_y = rounded.y;
    regions_ = lay_regions<float>(*environment_, flow, origin_);
    drag_.regions = regions_.data(), drag_.region_count = static_cast<int>(regions_.size());
}

void NativeEngine::actuate(std::span<const double> extensions, int steps) {
    bool moves = false;
    for (std::size_t i = 0; i < extension_.size(); ++i) {
        const auto next = static_cast<float>(extensions[body_.cell_of[i]]);
        moves = moves || next != extension_[i].own[0];
        extension_[i].own[0] = next;
    }
    // The slots are up to date if the muscles did not move on the way to the last knot either.
    if (moves || muscles_move_) {
        const auto pairs = static_cast<int>(body_.pairs.size());
        kernel_.reach_knot({task_.pairs, pairs, extension_.data(), static_cast<float>(steps)},
                           body_.slots.data());
    }
    muscles_move_ = moves;
    knot_steps_ = 0, knot_interval_ = steps;
}

Motion NativeEngine::step(double damping) {
    push_outline();
    knot_steps_ = std::min(knot_steps_ + 1, knot_interval_);
    task_.knot_steps = static_cast<float>(knot_steps_);
    task_.slowing = 1 - static_cast<float>(damping) * task_.time_step;
    const auto step = task_.gravity || task_.pieces == native::walls ? kernel_.step_anywhere : kernel_.step;
    const auto [squared_speed, beyond] = step(task_, now_.data(), next_.data());
    now_.swap(next_);
    const double speed = std::sqrt(static_cast<double>(squared_speed));
    moved_ = static_cast<float>(speed) * task_.time_step;
    return {speed, beyond};
}

/// Drag, self-collision, and the pull of walls.
void NativeEngine::push_outline() {
    const int first = body_.outline_group() * native::group_size;
    const auto touches = contact_.touches(now_.data(), moved_);
    if (drag_.group_count > 0)
        (regions_.empty() ? kernel_.drag : kernel_.drag_in_regions)(drag_, now_.data(), half_drag_.data(),
                                                                    &push_x_[first], &push_y_[first]);
    else if (touched_)
        std::fill(push_x_.begin() + first, push_x_.end(), 0.0f),
            std::fill(push_y_.begin() + first, push_y_.end(), 0.0f);
    touched_ = false;
    const auto push = [&](int node, Vec2f force) {
        push_x_[node] += force.x, push_y_[node] += force.y, touched_ = true;
    };
    for (const auto &[cell, a, b, forces] : touches)
        push(cell, forces.on_cell), push(a, forces.on_a), push(b, forces.on_b);
    if (!walls_.empty())
        pull_outline(
            walls_.view(), body_.model.outline, pull_of_walls_,
            [&](int node) {
                return Vec2f{now_[node].x, now_[node].y};
            },
            push);
    if (!touched_) return;
    // Copies of the last node are pushed as it is.
    for (std::size_t copy = body_.nodes; copy < now_.size(); ++copy)
        push_x_[copy] = push_x_[body_.nodes - 1], push_y_[copy] = push_y_[body_.nodes - 1];
}

std::vector<Vec2d> NativeEngine::positions() const {
    std::vector<Vec2d> result(static_cast<std::size_t>(body_.nodes));
    for (int node = 0; node < body_.nodes; ++node)
        result[body_.cell_of[node]] = origin_ + Vec2d{now_[node].x, now_[node].y};
    return result;
}

std::vector<Vec2d> NativeEngine::velocities() const {
    std::vector<Vec2d> result(static_cast<std::size_t>(body_.nodes));
    for (int node = 0; node < body_.nodes; ++node)
        result[body_.cell_of[node]] = {now_[node].vx, now_[node].vy};
    return result;
}

} // namespace planula
