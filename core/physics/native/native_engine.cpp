// SPDX-License-Identifier: MIT
#include "physics/native/native_engine.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace planula {

namespace {

Vec2f to_float(Vec2d v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }
Vec2d to_double(Vec2f v) { return {v.x, v.y}; }

std::vector<Vec2d> to_double(const std::vector<Vec2f> &values) {
    std::vector<Vec2d> result;
    for (const Vec2f v : values) result.push_back(to_double(v));
    return result;
}

} // namespace

void NativeEngine::load(const SoftBodyModel &model, const Environment &environment) {
    model_ = &model, environment_ = &environment;
    position_.clear();
    for (const Vec2d p : model.positions) position_.push_back(to_float(p));
    velocity_.assign(position_.size(), {});
    forces_.assign(position_.size(), {});
    law_.load(model, environment);

    // The ground is level beyond the ends of its polyline.
    const auto &line = environment.ground;
    const float left = -std::numeric_limits<float>::infinity();
    ground_.assign(1, {left, {line.empty() ? Vec2f{} : to_float(line.front()), {0, 1}}});
    for (std::size_t i = 1; i < line.size(); ++i) {
        const Vec2d along = line[i] - line[i - 1];
        const Vec2d normal = -right_normal(along) / length(along);
        ground_.push_back({static_cast<float>(line[i - 1].x), {to_float(line[i - 1]), to_float(normal)}});
    }
    if (!line.empty())
        ground_.push_back({static_cast<float>(line.back().x), {to_float(line.back()), {0, 1}}});
}

Motion NativeEngine::step(std::span<const double> rest_lengths, double damping) {
    law_.compute(rest_lengths, position_, velocity_, forces_);
    return integrate(static_cast<float>(damping));
}

Motion NativeEngine::integrate(float damping) {
    const auto dt = static_cast<float>(model_->parameters.time_step);
    const auto gravity = static_cast<float>(environment_->gravity);
    const auto friction = static_cast<float>(environment_->friction);
    const float slowing = 1 - damping * dt;
    float fastest = 0;
    bool finite = true;
    for (std::size_t i = 0; i < position_.size(); ++i) {
        Vec2f v = (velocity_[i] + forces_[i] * dt) * slowing;
        v.y -= gravity * dt;
        if (environment_->has_ground)
            v = ground_contact(position_[i], v, ground_below(position_[i].x), friction, dt);
        velocity_[i] = v;
        position_[i] += v * dt;
        const float squared = squared_length(v);
        finite = finite && std::isfinite(squared);
        fastest = std::max(fastest, squared);
    }
    const double speed = std::sqrt(static_cast<double>(fastest));
    return {speed, !finite || speed * model_->parameters.time_step > model_->parameters.node_speed_limit};
}

GroundPlane<float> NativeEngine::ground_below(float x) const {
    const auto beyond = std::upper_bound(ground_.begin() + 1, ground_.end(), x,
                                         [](float value, const Slope &slope) { return value < slope.from; });
    return (beyond - 1)->plane;
}

std::vector<Vec2d> NativeEngine::positions() const { return to_double(position_); }
std::vector<Vec2d> NativeEngine::velocities() const { return to_double(velocity_); }

} // namespace planula
