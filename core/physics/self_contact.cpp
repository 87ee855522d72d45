// SPDX-License-Identifier: MIT
#include "physics/self_contact.h"

#include "physics/laws/contact.h"

#include <algorithm>
#include <limits>

namespace planula {

namespace {

template <class T> Vec2<T> unit(Vec2<T> v) { return v / std::sqrt(std::max(squared_length(v), T(1e-12))); }

/// Whether a cell that lies so from the foot on its nearest link, at t of it, is outside the body.
template <class T>
bool is_outside(const SoftBodyModel &model, std::size_t contact_cell, int link, T t, Vec2<T> from_foot,
                Points<T> positions) {
    const auto normal = [&](int index) {
        const OutlineLink &l = model.outline[index];
        return unit(right_normal(positions[l.b] - positions[l.a]));
    };
    if (t > 0 && t < 1) return dot(from_foot, normal(link)) >= 0;

    // At a corner both links that meet there decide.
    const int other = t > 0 ? model.outline[link].next : model.outline[link].previous;
    if (other < 0 || model.is_masked(contact_cell, static_cast<std::size_t>(other))) return true;
    return dot(from_foot, normal(link) + normal(other)) >= 0;
}

} // namespace

template <class T>
Touch<T> touch_of(const SoftBodyModel &model, std::size_t contact_cell, int link, Points<T> positions) {
    const Parameters &p = model.parameters;
    const int cell = model.contact_cells[contact_cell], a = model.outline[link].a, b = model.outline[link].b;
    const auto foot = foot_on_segment(positions[cell], positions[a], positions[b]);
    const Vec2<T> from_foot = positions[cell] - foot.point;
    const Vec2<T> force =
        contact_force(from_foot, is_outside(model, contact_cell, link, foot.t, from_foot, positions),
                      static_cast<T>(p.contact_stiffness), static_cast<T>(p.contact_radius),
                      static_cast<T>(p.contact_depth));

    // The link takes the reaction by the lever of the foot.
    return {cell, a, b, force, -force * (1 - foot.t), -force * foot.t};
}

template Touch<float> touch_of(const SoftBodyModel &, std::size_t, int, Points<float>);
template Touch<double> touch_of(const SoftBodyModel &, std::size_t, int, Points<double>);

template <class T> void SelfContact<T>::load(const SoftBodyModel &model) {
    model_ = &model;
    reach_ = static_cast<T>(std::max(model.parameters.contact_radius, model.parameters.contact_depth));
    listed_at_.clear();
}

template <class T>
void SelfContact<T>::add_forces(std::span<const Vec2<T>> positions, std::span<Vec2<T>> forces) {
    if (list_is_stale(positions)) make_list(positions);
    for (std::size_t i = 0; i < model_->contact_cells.size(); ++i) {
        const int link = nearest_link(i, positions);
        if (link < 0) continue;
        const auto touch = touch_of<T>(*model_, i, link, positions);
        forces[touch.cell] += touch.on_cell;
        forces[touch.a] += touch.on_a;
        forces[touch.b] += touch.on_b;
    }
}

template <class T> bool SelfContact<T>::list_is_stale(std::span<const Vec2<T>> positions) const {
    if (listed_at_.empty()) return true;
    T farthest = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
        farthest = std::max(farthest, squared_length(positions[i] - listed_at_[i]));
    return farthest > T(0.25) * skin_ * skin_;
}

template <class T> void SelfContact<T>::make_list(std::span<const Vec2<T>> positions) {
    listed_at_.assign(positions.begin(), positions.end());
    first_.assign(1, 0);
    candidates_.clear();
    const T reach = reach_ + skin_;
    for (std::size_t cell = 0; cell < model_->contact_cells.size(); ++cell) {
        const Vec2<T> p = positions[model_->contact_cells[cell]];
        for (std::size_t link = 0; link < model_->outline.size(); ++link) {
            if (model_->is_masked(cell, link)) continue;
            const auto &[a, b, solid, previous, next] = model_->outline[link];
            const auto foot = foot_on_segment(p, positions[a], positions[b]);
            if (squared_length(p - foot.point) < reach * reach) candidates_.push_back(static_cast<int>(link));
        }
        first_.push_back(static_cast<int>(candidates_.size()));
    }
}

/// Of equals the lowest; -1: none is listed.
template <class T>
int SelfContact<T>::nearest_link(std::size_t contact_cell, std::span<const Vec2<T>> positions) const {
    const Vec2<T> p = positions[model_->contact_cells[contact_cell]];
    T nearest = std::numeric_limits<T>::infinity();
    int found = -1;
    for (int i = first_[contact_cell]; i < first_[contact_cell + 1]; ++i) {
        const OutlineLink &link = model_->outline[candidates_[i]];
        const auto foot = foot_on_segment(p, positions[link.a], positions[link.b]);
        const T squared = squared_length(p - foot.point);
        if (squared < nearest) nearest = squared, found = candidates_[i];
    }
    return found;
}

template class SelfContact<float>;
template class SelfContact<double>;

} // namespace planula
