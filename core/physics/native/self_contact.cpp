// SPDX-License-Identifier: MIT
#include "physics/native/self_contact.h"

#include "physics/laws/contact.h"

#include <algorithm>
#include <limits>

namespace planula {

namespace {

Vec2f unit(Vec2f v) { return v / std::sqrt(std::max(squared_length(v), 1e-12f)); }

} // namespace

void SelfContact::load(const SoftBodyModel &model) {
    model_ = &model;
    stiffness_ = static_cast<float>(model.parameters.contact_stiffness);
    radius_ = static_cast<float>(model.parameters.contact_radius);
    depth_ = static_cast<float>(model.parameters.contact_depth);
    listed_at_.clear();
}

void SelfContact::add_forces(std::span<const Vec2f> positions, std::span<Vec2f> forces) {
    if (list_is_stale(positions)) make_list(positions);
    for (std::size_t cell = 0; cell < model_->contact_cells.size(); ++cell)
        if (first_[cell] != first_[cell + 1]) push(cell, positions, forces);
}

bool SelfContact::list_is_stale(std::span<const Vec2f> positions) const {
    if (listed_at_.empty()) return true;
    float farthest = 0;
    for (std::size_t i = 0; i < positions.size(); ++i)
        farthest = std::max(farthest, squared_length(positions[i] - listed_at_[i]));
    return farthest > 0.25f * skin_ * skin_;
}

void SelfContact::make_list(std::span<const Vec2f> positions) {
    listed_at_.assign(positions.begin(), positions.end());
    first_.assign(1, 0);
    candidates_.clear();
    const float reach = std::max(radius_, depth_) + skin_;
    for (std::size_t cell = 0; cell < model_->contact_cells.size(); ++cell) {
        const Vec2f p = positions[model_->contact_cells[cell]];
        for (std::size_t link = 0; link < model_->outline.size(); ++link) {
            if (model_->is_masked(cell, link)) continue;
            const auto &[a, b, solid, previous, next] = model_->outline[link];
            const auto foot = foot_on_segment(p, positions[a], positions[b]);
            if (squared_length(p - foot.point) < reach * reach) candidates_.push_back(static_cast<int>(link));
        }
        first_.push_back(static_cast<int>(candidates_.size()));
    }
}

void SelfContact::push(std::size_t contact_cell, std::span<const Vec2f> positions,
                       std::span<Vec2f> forces) const {
    // The nearest unmasked link; of equals the lowest.
    const int cell = model_->contact_cells[contact_cell];
    const Vec2f p = positions[cell];
    float nearest = std::numeric_limits<float>::infinity();
    int hit = -1;
    Foot<float> foot{};
    for (int i = first_[contact_cell]; i < first_[contact_cell + 1]; ++i) {
        const OutlineLink &link = model_->outline[candidates_[i]];
        const auto candidate = foot_on_segment(p, positions[link.a], positions[link.b]);
        const float squared = squared_length(p - candidate.point);
        if (squared < nearest) nearest = squared, hit = candidates_[i], foot = candidate;
    }
    if (hit < 0) return;

    // Equal and opposite forces on the cell and, by the lever of the foot, on the link's ends.
    const Vec2f from_foot = p - foot.point;
    const bool outside = is_outside(contact_cell, hit, foot.t, from_foot, positions);
    const Vec2f force = contact_force(from_foot, outside, stiffness_, radius_, depth_);
    const OutlineLink &link = model_->outline[hit];
    forces[cell] += force;
    forces[link.a] -= force * (1 - foot.t);
    forces[link.b] -= force * foot.t;
}

bool SelfContact::is_outside(std::size_t contact_cell, int link, float t, Vec2f from_foot,
                             std::span<const Vec2f> positions) const {
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

} // namespace planula
