// SPDX-License-Identifier: MIT
#include "physics/forces.h"

#include "physics/laws/drag.h"
#include "physics/laws/spring.h"

#include <algorithm>

namespace planula {

template <class T> void Forces<T>::load(const SoftBodyModel &model, const Environment &environment) {
    model_ = &model, environment_ = &environment;
    pressure_.clear();
    const BodyParameters &p = model.body;
    for (const double area : model.areas)
        pressure_.push_back(pressure_of<T>(area, p.pressure_stiffness, p.area_floor));
    contact_.load(model);
}

template <class T>
void Forces<T>::compute(std::span<const double> rest_lengths, std::span<const Vec2<T>> position,
                        std::span<const Vec2<T>> velocity, std::span<Vec2<T>> forces) {
    std::fill(forces.begin(), forces.end(), Vec2<T>{});
    add_springs(rest_lengths, position, velocity, forces);
    add_pressure(position, forces);
    add_drag(position, velocity, forces);
    add_contact(position, forces);
}

template <class T>
void Forces<T>::add_springs(std::span<const double> rest_lengths, std::span<const Vec2<T>> position,
                            std::span<const Vec2<T>> velocity, std::span<Vec2<T>> forces) const {
    const auto stiffness = static_cast<T>(model_->body.spring_stiffness);
    const auto damping = static_cast<T>(model_->body.spring_damping);
    for (std::size_t i = 0; i < model_->links.size(); ++i) {
        const auto [a, b] = model_->links[i];
        const auto spring = spring_to(position[b] - position[a], velocity[b] - velocity[a]);
        const Vec2<T> force =
            spring_force(spring, stiffness, stiffness * static_cast<T>(rest_lengths[i]), damping);
        forces[a] += force;
        forces[b] -= force;
    }
}

template <class T>
void Forces<T>::add_pressure(std::span<const Vec2<T>> position, std::span<Vec2<T>> forces) const {
    for (std::size_t i = 0; i < model_->triangles.size(); ++i) {
        const auto [a, b, c] = model_->triangles[i];
        forces[a] += pressure_force(position[b] - position[a], position[c] - position[a], pressure_[i]);
        forces[b] += pressure_force(position[c] - position[b], position[a] - position[b], pressure_[i]);
        forces[c] += pressure_force(position[a] - position[c], position[b] - position[c], pressure_[i]);
    }
}

template <class T>
void Forces<T>::add_drag(std::span<const Vec2<T>> position, std::span<const Vec2<T>> velocity,
                         std::span<Vec2<T>> forces) const {
    if (!environment_->has_fluid()) return;
    const auto normal = static_cast<T>(environment_->drag_normal);
    const auto tangential = static_cast<T>(environment_->drag_tangential);
    const Vec2<T> flow{static_cast<T>(environment_->flow.x), static_cast<T>(environment_->flow.y)};
    for (const OutlineLink &link : model_->outline) {
        const Vec2<T> through = (velocity[link.a] + velocity[link.b]) * T(0.5) - flow;
        const Vec2<T> half =
            drag_force(position[link.b] - position[link.a], through, normal, tangential) * T(0.5);
        forces[link.a] += half;
        forces[link.b] += half;
    }
}

template <class T> void Forces<T>::add_contact(std::span<const Vec2<T>> position, std::span<Vec2<T>> forces) {
    contact_.add_forces(position, forces);
}

template class Forces<double>;

} // namespace planula
