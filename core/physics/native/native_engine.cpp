// SPDX-License-Identifier: MIT
#include "physics/native/native_engine.h"

#include "physics/laws/drag.h"
#include "physics/laws/pressure.h"
#include "physics/laws/spring.h"

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
    forces.assign(position_.size(), {});

    // Small triangles get the stiffness of area_floor.
    area_.clear(), pressure_stiffness_.clear();
    for (const double area : model.areas) {
        area_.push_back(static_cast<float>(area));
        pressure_stiffness_.push_back(static_cast<float>(model.parameters.pressure_stiffness /
                                                         std::max(area, model.parameters.area_floor)));
    }
    contact_.load(model);

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
    std::fill(forces.begin(), forces.end(), Vec2f{});
    add_spring_forces(rest_lengths);
    add_pressure_forces();
    add_drag_forces();
    add_contact_forces();
    return integrate(static_cast<float>(damping));
}

void NativeEngine::add_spring_forces(std::span<const double> rest_lengths) {
    const auto stiffness = static_cast<float>(model_->parameters.spring_stiffness);
    const auto damping = static_cast<float>(model_->parameters.spring_damping);
    for (std::size_t i = 0; i < model_->links.size(); ++i) {
        const auto [a, b] = model_->links[i];
        const Vec2f force = spring_force(position_[b] - position_[a], velocity_[b] - velocity_[a],
                                         static_cast<float>(rest_lengths[i]), stiffness, damping);
        forces[a] += force;
        forces[b] -= force;
    }
}

void NativeEngine::add_pressure_forces() {
    for (std::size_t i = 0; i < model_->triangles.size(); ++i) {
        const auto [a, b, c] = model_->triangles[i];
        const auto push =
            pressure_forces(position_[a], position_[b], position_[c], area_[i], pressure_stiffness_[i]);
        forces[a] += push.a;
        forces[b] += push.b;
        forces[c] += push.c;
    }
}

void NativeEngine::add_drag_forces() {
    if (!environment_->has_fluid()) return;
    const auto normal = static_cast<float>(environment_->drag_normal);
    const auto tangential = static_cast<float>(environment_->drag_tangential);
    const Vec2f flow = to_float(environment_->flow);
    for (const OutlineLink &link : model_->outline) {
        const Vec2f velocity = (velocity_[link.a] + velocity_[link.b]) * 0.5f - flow;
        const Vec2f half =
            drag_force(position_[link.b] - position_[link.a], velocity, normal, tangential) * 0.5f;
        forces[link.a] += half;
        forces[link.b] += half;
    }
}

void NativeEngine::add_contact_forces() { contact_.add_forces(position_, forces); }

Motion NativeEngine::integrate(float damping) {
    const auto dt = static_cast<float>(model_->parameters.time_step);
    const auto gravity = static_cast<float>(environment_->gravity);
    const auto friction = static_cast<float>(environment_->friction);
    const float slowing = 1 - damping * dt;
    float fastest = 0;
    bool finite = true;
    for (std::size_t i = 0; i < position_.size(); ++i) {
        Vec2f v = (velocity_[i] + forces[i] * dt) * slowing;
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
