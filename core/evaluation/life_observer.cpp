// SPDX-License-Identifier: MIT
#include "evaluation/life_observer.h"

#include "evaluation/rhythm.h"
#include "physics/energy.h"
#include "physics/laws/contact.h"

#include <algorithm>
#include <array>

namespace planula {

namespace {

// A cell nearer to the ground touches it: wider than what the engines leave between the two, 1e-5 to 1e-3.
constexpr double touching_distance = 0.01;

/// Whether a point is that near to one of the lines from each of these points to the next.
bool is_near(Vec2d point, std::span<const Vec2d> line) {
    for (std::size_t i = 1; i < line.size(); ++i)
        if (length(point - foot_on_segment(point, line[i - 1], line[i]).point) < touching_distance)
            return true;
    return false;
}

/// Whether a cell touches the ground, the ceiling or an obstacle.
bool is_touching(const Environment &environment, Vec2d point) {
    if (is_at_ground(environment, point, touching_distance)) return true;
    const auto &ceiling = environment.ceiling;
    if (!ceiling.empty() &&
        (height_of(ceiling, point.x) - point.y < touching_distance || is_near(point, ceiling)))
        return true;
    return std::any_of(environment.obstacles.begin(), environment.obstacles.end(),
                       [&](const Obstacle &obstacle) {
                           return is_near(point, obstacle.points) ||
                                  is_near(point, std::array{obstacle.points.back(), obstacle.points.front()});
                       });
}

} // namespace

bool LifeObserver::reads(std::initializer_list<Observation> any) const {
    return std::any_of(any.begin(), any.end(), [&](Observation one) { return observed_.has(one); });
}

void LifeObserver::begin(const SoftBodyModel &model, const Environment &environment, const Engine &engine,
                         std::span<const double> signal) {
    model_ = &model, environment_ = &environment;
    rest_lengths_ = reference::RestLengths(model);
    positions_ = engine.positions();
    add_signal(0, signal);
}

/// Signals of other cells are no part of one rhythm.
void LifeObserver::change(const SoftBodyModel &model, const Environment &environment, const Engine &engine) {
    if (model.nodes() != model_->nodes()) late_signals_.clear();
    model_ = &model, environment_ = &environment;
    rest_lengths_ = reference::RestLengths(model);
    positions_ = engine.positions();
}

void LifeObserver::actuate(std::span<const double> extensions, int steps) {
    rest_lengths_.actuate(extensions, steps);
}

void LifeObserver::step(int t, const Engine &engine, std::span<const double> signal) {
    using enum Observation;
    ++steps_;
    if (reads({work, net_work, elastic_energy, contact_time, contact_share, final_shape})) {
        const std::vector<Vec2d> positions = engine.positions();
        if (reads({work, net_work, elastic_energy})) add_energy(positions);
        if (reads({contact_time, contact_share})) add_contact(std::span(positions).first(signal.size()));
        positions_ = positions;
    }
    add_signal(t, signal);
}

/// In a step the rest lengths change first, at the places where the cells are, and then the body moves.
void LifeObserver::add_energy(std::span<const Vec2d> positions) {
    const auto now = rest_lengths_.now();
    before_.assign(now.begin(), now.end());
    rest_lengths_.advance();
    for (std::size_t i = 0; i < before_.size(); ++i) {
        const double length =
            planula::length(positions_[model_->links[i].b] - positions_[model_->links[i].a]);
        const double gain =
            muscle_work(model_->body.spring_stiffness, length, before_[i], rest_lengths_.now()[i]);
        net_work_ += gain;
        work_ += std::max(gain, 0.0);
    }
    if (observed_.has(Observation::elastic_energy))
        energy_ += planula::elastic_energy(*model_, rest_lengths_.now(), positions);
}

void LifeObserver::add_contact(std::span<const Vec2d> positions) {
    positions = positions.first(positions.size() - static_cast<std::size_t>(model_->object_nodes));
    const auto touching = std::count_if(positions.begin(), positions.end(),
                                        [&](Vec2d position) { return is_touching(*environment_, position); });
    touching_steps_ += touching > 0;
    touching_cells_ += static_cast<double>(touching) / static_cast<double>(positions.size());
}

void LifeObserver::add_signal(int t, std::span<const double> signal) {
    using enum Observation;
    const std::vector<double> sample(signal.begin(), signal.end());
    if (observed_.has(signals) && t % gait_.path_interval == 0) signals_.push_back(sample);
    const bool is_late = 2 * t >= gait_.locomotion_steps && t % gait_.knot_interval == 0;
    if (reads({period, gait_phases}) && is_late) late_signals_.push_back(sample);
}

void LifeObserver::finish(Observations &observations) const {
    const double steps = std::max(steps_, 1);
    Observations all;
    all.work = work_, all.net_work = net_work_, all.elastic_energy = energy_ / steps;
    all.contact_time = touching_steps_ / steps, all.contact_share = touching_cells_ / steps;
    all.signals = signals_;
    if (const double knots = period_of(late_signals_); knots > 0) {
        all.period = knots * gait_.knot_interval;
        all.gait_phases = phases_of(late_signals_, knots);
    }
    if (model_) all.final_shape.assign(positions_.begin(), positions_.end() - model_->object_nodes);
        // Those that were asked for.
#define OBSERVATION(type, name, initial, unit, known, exists, meaning)                                       \
    if (KnownAfter::known == KnownAfter::locomotion && observed_.has(Observation::name))                     \
        observations.name = all.name;
#include "evaluation/observations.inl"
}

} // namespace planula
