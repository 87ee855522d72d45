// SPDX-License-Identifier: MIT
#include "physics/self_contact.h"

#include "physics/laws/contact.h"

#include <algorithm>

namespace planula {

template <class T> Touch<T> touch_of(const SoftBodyModel &model, int cell, int link, Points<T> positions) {
    const BodyParameters &p = model.body;
    const int a = model.outline[link].a, b = model.outline[link].b;
    const auto foot = foot_on_segment(positions[cell], positions[a], positions[b]);
    const Vec2<T> force = contact_force(positions[cell] - foot.point, static_cast<T>(p.contact_stiffness),
                                        static_cast<T>(p.contact_radius));

    // The link takes the reaction by the lever of the foot.
    return {cell, a, b, force, -force * (1 - foot.t), -force * foot.t};
}

template Touch<float> touch_of(const SoftBodyModel &, int, int, Points<float>);
template Touch<double> touch_of(const SoftBodyModel &, int, int, Points<double>);

template <class T> void SelfContact<T>::load(const SoftBodyModel &model) {
    model_ = &model;
    reach_ = static_cast<T>(model.body.contact_radius);
    listed_at_.clear();
}

template <class T>
void SelfContact<T>::add_forces(std::span<const Vec2<T>> positions, std::span<Vec2<T>> forces) {
    if (list_is_stale(positions)) make_list(positions);
    for (std::size_t cell = 0; cell < model_->contact_cells.size(); ++cell)
        for (int i = first_[cell]; i < first_[cell + 1]; ++i) {
            const auto touch = touch_of<T>(*model_, model_->contact_cells[cell], candidates_[i], positions);
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
            const OutlineLink &l = model_->outline[link];
            const auto foot = foot_on_segment(p, positions[l.a], positions[l.b]);
            if (squared_length(p - foot.point) < reach * reach) candidates_.push_back(static_cast<int>(link));
        }
        first_.push_back(static_cast<int>(candidates_.size()));
    }
}

template class SelfContact<float>;
template class SelfContact<double>;

} // namespace planula
