// SPDX-License-Identifier: MIT
// Self-collision of one soft body: which cell meets which link, and with what force (decision 0007).
#pragma once

#include "physics/soft_body.h"

#include <span>
#include <vector>

namespace planula {

/// Positions in an array of records whose first two numbers they are.
template <class T> class Points {
  public:
    Points(const T *first, int stride) : first_(first), stride_(stride) {}
    Points(std::span<const Vec2<T>> positions) : Points(&positions.data()->x, 2) {}
    Vec2<T> operator[](int i) const { return {first_[i * stride_], first_[i * stride_ + 1]}; }

  private:
    const T *first_;
    int stride_;
};

/// A cell pushed by a link: the force on the cell and the opposite one on the link's ends a and b.
template <class T> struct Touch {
    int cell, a, b;
    Vec2<T> on_cell, on_a, on_b;
};

/// The law for a contact cell and an unmasked outline link; the forces are 0 out of reach.
template <class T> Touch<T> touch_of(const SoftBodyModel &model, int cell, int link, Points<T> positions);

/// Finds the pairs that touch. Those that may meet soon are kept in a list (Verlet) that is made again when a node has moved by half its skin; the forces are those of a search over all pairs, to the bit.
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

    const SoftBodyModel *model_ = nullptr;
    T skin_, reach_ = 0;
    std::vector<Vec2<T>> listed_at_; // positions at which the list was made
    std::vector<int> first_;         // of contact cell i in candidates_; one more than there are cells
    std::vector<int> candidates_;    // outline links, ascending for each cell
};

} // namespace planula
