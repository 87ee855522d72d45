// SPDX-License-Identifier: MIT
#include "physics/self_contact.h"

#include "physics/laws/contact.h"

#include <algorithm>
#include <limits>

namespace planula {

namespace {

template <class T> Vec2<T> unit(Vec2<T> v) { return v / std::sqrt(std::max(squared_length(v), T(1e-12))); }

} // namespace

template <class T> void SelfContact<T>::load(const SoftBodyModel &model) {
    model_ = &model;
    stiffness_ = static_cast<T>(model.parameters.contact_stiffness);
    radius_ = static_cast<T>(model.parameters.contact_radius);
    depth_ = static_cast<T>(model.parameters.contact_depth);
    listed_at_.clear();
}

template <class T>
void SelfContact<T>::add_forces(std::span<const Vec2<T>> positions, std::span<Vec2<T>> forces) {
    if (list_is_stale(positions)) make_list(positions);
    for (std::size_t cell = 0; cell < model_->contact_cells.size(); ++cell)
        if (first_[cell] != first_[cell + 1]) push(cell, positions, forces);
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
    const T reach = std::max(radius_, depth_) + skin_;
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

template <class T>
void SelfContact<T>::push(std::size_t contact_cell, std::span<const Vec2<T>> positions,
                          std::span<Vec2<T>> forces) const {
    // The nearest unmasked link; of equals the lowest.
    const int cell = model_->contact_cells[contact_cell];
    const Vec2<T> p = positions[cell];
    T nearest = std::numeric_limits<T>::infinity();
    int hit = -1;
    Foot<T> foot{};
    for (int i = first_[contact_cell]; i < first_[contact_cell + 1]; ++i) {
        const OutlineLink &link = model_->outline[candidates_[i]];
        const auto candidate = foot_on_segment(p, positions[link.a], positions[link.b]);
        const T squared = squared_length(p - candidate.point);
        if (squared < nearest) nearest = squared, hit = candidates_[i], foot = candidate;
    }
    if (hit < 0) return;

    // Equal and opposite forces on the cell and, by the lever of the foot, on the link's ends.
    const Vec2<T> from_foot = p - foot.point;
    const bool outside = is_outside(contact_cell, hit, foot.t, from_foot, positions);
    const Vec2<T> force = contact_force(from_foot, outside, stiffness_, radius_, depth_);
    const OutlineLink &link = model_->outline[hit];
    forces[cell] += force;
    forces[link.a] -= force * (1 - foot.t);
    forces[link.b] -= force * foot.t;
}

template <class T>
bool SelfContact<T>::is_outside(std::size_t contact_cell, int link, T t, Vec2<T> from_foot,
                                std::span<const Vec2<T>> positions) const {
    const auto normal = [&](int index) {
        const OutlineLink &l = model_->outline[index];
        return unit(right_normal(positions[l.b] - positions[l.a]));
    };
    if (t > 0 && t < 1) return dot(from_foot, normal(link)) >= 0;

    // At a corner both links that meet there decide.
    const int other = t > 0 ? model_->outline[link].next : model_->outline[link].previous;
    if (other < 0 || model_->is_masked(contact_cell, static_cast<std::size_t>(other))) return true;
    return dot(from_foot, normal(link) + normal(other)) >= 0;
}

template class SelfContact<float>;
template class SelfContact<double>;

} // namespace planula
