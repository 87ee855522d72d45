// SPDX-License-Identifier: MIT
// Self-collision of one soft body: which cell meets which link, and the forces of it. Pairs that may meet
// soon are kept in a list (Verlet) that is made again when a node has moved by half its skin; the forces are
// those of a search over all pairs, to the bit.
#pragma once

#include "physics/soft_body.h"

#include <span>
#include <vector>

namespace planula {

template <class T> class SelfContact {
  public:
    /// `skin`: how much farther than the contact law reaches pairs are listed; any skin gives the same
    /// forces.
    explicit SelfContact(T skin = T(0.8)) : skin_(skin) {}

    void load(const SoftBodyModel &model);
    /// Adds the contact forces at these positions to `forces`.
    void add_forces(std::span<const Vec2<T>> positions, std::span<Vec2<T>> forces);

  private:
    bool list_is_stale(std::span<const Vec2<T>> positions) const;
    void make_list(std::span<const Vec2<T>> positions);
    void push(std::size_t contact_cell, std::span<const Vec2<T>> positions, std::span<Vec2<T>> forces) const;
    bool is_outside(std::size_t contact_cell, int link, T t, Vec2<T> from_foot,
                    std::span<const Vec2<T>> positions) const;

    const SoftBodyModel *model_ = nullptr;
    T skin_, stiffness_ = 0, radius_ = 0, depth_ = 0;
    std::vector<Vec2<T>> listed_at_; // positions at which the list was made
    std::vector<int> first_;         // of contact cell i in candidates_; one more than there are cells
    std::vector<int> candidates_;    // outline links, ascending for each cell
};

} // namespace planula
