// SPDX-License-Identifier: MIT
// Self-collision of one soft body: which cell meets which link, and with what force (MODEL section 3,
// "Self-collision law"). Pairs that may meet soon are kept in a list (Verlet) that is made again when nodes
// have moved against each other by more than its skin, and while no listed pair can have come into reach
// nothing is looked at; the touches are those of a search over all pairs, to the bit.
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

/// A cell pushed by a link: `force` on the cell, the opposite on the link's ends a and b by the lever of the
/// foot, 1 − t and t.
template <class T> struct Touch {
    int cell, a, b;
    Vec2<T> force;
    T t;
};

template <class T> class SelfContact {
  public:
    /// `skin`: how much farther than the contact law reaches pairs are listed; any skin gives the same
    /// touches.
    explicit SelfContact(T skin = T(0.8)) : skin_(skin) {}

    /// Forgets the list. The model must outlive the use of this.
    void load(const SoftBodyModel &model);
    /// The touches at these positions, in the order of contact cells; valid until the next call.
    std::span<const Touch<T>> touches(Points<T> positions);
    /// Adds their forces.
    void add_forces(std::span<const Vec2<T>> positions, std::span<Vec2<T>> forces);

  private:
    struct Nearest {
        int link = -1;
        T squared; // distance
        Vec2<T> from_foot;
        T t;
    };

    T motion_since(const std::vector<Vec2<T>> &then, Points<T> now) const;
    void remember(Points<T> positions, std::vector<Vec2<T>> &at) const;
    void make_list(Points<T> positions);
    Nearest nearest_link(std::size_t contact_cell, Points<T> positions) const;
    Touch<T> touch(std::size_t contact_cell, const Nearest &nearest, Points<T> positions) const;
    bool is_outside(std::size_t contact_cell, const Nearest &nearest, Points<T> positions) const;

    const SoftBodyModel *model_ = nullptr;
    T skin_, stiffness_ = 0, radius_ = 0, depth_ = 0;
    std::vector<int> nodes_;           // that take part
    std::vector<Vec2<T>> listed_at_;   // where they were when the list was made
    std::vector<Vec2<T>> searched_at_; // and when pairs were last looked at
    T clearance_ = 0;                  // by which no pair was in reach then
    std::vector<int> first_;           // of contact cell i in candidates_; one more than there are cells
    std::vector<int> candidates_;      // outline links, ascending for each cell
    std::vector<Touch<T>> touches_;
};

} // namespace planula
