// SPDX-License-Identifier: MIT
#include "physics/self_contact.h"

#include "physics/laws/contact.h"

#include <algorithm>
#include <limits>

namespace planula {

namespace {

template <class T> Vec2<T> unit(Vec2<T> v) { return v / std::sqrt(std::max(squared_length(v), T(1e-12))); }

/// The cells that may be pushed, ascending.
std::vector<int> involved_nodes(const SoftBodyModel &model) {
    std::vector<int> nodes = model.contact_cells;
    for (const OutlineLink &link : model.outline) nodes.insert(nodes.end(), {link.a, link.b});
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
}

} // namespace

template <class T> void SelfContact<T>::load(const SoftBodyModel &model) {
    model_ = &model;
    stiffness_ = static_cast<T>(model.parameters.contact_stiffness);
    radius_ = static_cast<T>(model.parameters.contact_radius);
    depth_ = static_cast<T>(model.parameters.contact_depth);
    nodes_ = model.contact_cells.empty() ? std::vector<int>{} : involved_nodes(model);
    listed_at_.clear(), searched_at_.clear(), touches_.clear();
}

template <class T> std::span<const Touch<T>> SelfContact<T>::touches(Points<T> positions) {
    // Nothing can have come into reach, or all that may is in the list.
    if (nodes_.empty()) return {};
    if (!(motion_since(searched_at_, positions) >= clearance_)) return {};
    T moved = motion_since(listed_at_, positions);
    if (!(moved < skin_)) make_list(positions), moved = 0;

    // Each cell and the link nearest to it, if that is in reach.
    touches_.clear();
    const T reach = std::max(radius_, depth_);
    T least = std::numeric_limits<T>::infinity();
    for (std::size_t cell = 0; cell + 1 < first_.size(); ++cell) {
        if (first_[cell] == first_[cell + 1]) continue;
        const Nearest nearest = nearest_link(cell, positions);
        least = std::min(least, nearest.squared);
        if (!(nearest.squared < reach * reach)) continue;
        const Touch<T> found = touch(cell, nearest, positions);
        if (found.force != Vec2<T>{}) touches_.push_back(found);
    }

    // The margin is far above what rounding can do to these distances.
    clearance_ = std::min(std::sqrt(least) - reach, skin_ - moved) - T(1e-3);
    remember(positions, searched_at_);
    return touches_;
}

template <class T>
void SelfContact<T>::add_forces(std::span<const Vec2<T>> positions, std::span<Vec2<T>> forces) {
    for (const auto &[cell, a, b, force, t] : touches(positions)) {
        forces[cell] += force;
        forces[a] -= force * (1 - t);
        forces[b] -= force * t;
    }
}

/// At most so much has the distance of two nodes, or of a node from a link, changed: the diagonal of the box
/// around all displacements. Infinite if nothing is remembered.
template <class T> T SelfContact<T>::motion_since(const std::vector<Vec2<T>> &then, Points<T> now) const {
    if (then.empty()) return std::numeric_limits<T>::infinity();
    Vec2<T> low = now[nodes_[0]] - then[0], high = low;
    for (std::size_t i = 1; i < nodes_.size(); ++i) {
        const Vec2<T> moved = now[nodes_[i]] - then[i];
        low = {std::min(low.x, moved.x), std::min(low.y, moved.y)};
        high = {std::max(high.x, moved.x), std::max(high.y, moved.y)};
    }
    return length(high - low);
}

template <class T> void SelfContact<T>::remember(Points<T> positions, std::vector<Vec2<T>> &at) const {
    at.clear();
    for (const int node : nodes_) at.push_back(positions[node]);
}

template <class T> void SelfContact<T>::make_list(Points<T> positions) {
    remember(positions, listed_at_);
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

/// Of equals the lowest.
template <class T>
auto SelfContact<T>::nearest_link(std::size_t contact_cell, Points<T> positions) const -> Nearest {
    const Vec2<T> p = positions[model_->contact_cells[contact_cell]];
    Nearest nearest{.squared = std::numeric_limits<T>::infinity()};
    for (int i = first_[contact_cell]; i < first_[contact_cell + 1]; ++i) {
        const OutlineLink &link = model_->outline[candidates_[i]];
        const auto foot = foot_on_segment(p, positions[link.a], positions[link.b]);
        const Vec2<T> from_foot = p - foot.point;
        const T squared = squared_length(from_foot);
        if (squared < nearest.squared) nearest = {candidates_[i], squared, from_foot, foot.t};
    }
    return nearest;
}

template <class T>
Touch<T> SelfContact<T>::touch(std::size_t contact_cell, const Nearest &nearest, Points<T> positions) const {
    const bool outside = is_outside(contact_cell, nearest, positions);
    const OutlineLink &link = model_->outline[nearest.link];
    return {model_->contact_cells[contact_cell], link.a, link.b,
            contact_force(nearest.from_foot, outside, stiffness_, radius_, depth_), nearest.t};
}

template <class T>
bool SelfContact<T>::is_outside(std::size_t contact_cell, const Nearest &nearest, Points<T> positions) const {
    const auto normal = [&](int index) {
        const OutlineLink &l = model_->outline[index];
        return unit(right_normal(positions[l.b] - positions[l.a]));
    };
    if (nearest.t > 0 && nearest.t < 1) return dot(nearest.from_foot, normal(nearest.link)) >= 0;

    // At a corner both links that meet there decide.
    const OutlineLink &link = model_->outline[nearest.link];
    const int other = nearest.t > 0 ? link.next : link.previous;
    if (other < 0 || model_->is_masked(contact_cell, static_cast<std::size_t>(other))) return true;
    return dot(nearest.from_foot, normal(nearest.link) + normal(other)) >= 0;
}

template class SelfContact<float>;
template class SelfContact<double>;

} // namespace planula
