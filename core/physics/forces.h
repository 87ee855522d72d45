// SPDX-License-Identifier: MIT
// The forces on the nodes of one soft body, a family at a time, on the number type of an engine (§2.5;
// decisions 0006 to 0010). Every sum is made in the order of links, triangles, outline and contact cells,
// so it depends on the body alone. Gravity and the ground are the engine's own.
#pragma once

#include "physics/environment.h"
#include "physics/laws/pressure.h"
#include "physics/self_contact.h"

#include <span>
#include <vector>

namespace planula {

template <class T> class Forces {
  public:
    /// Model and environment must outlive the use of this.
    void load(const SoftBodyModel &model, const Environment &environment);

    /// All families at this state, into `forces`; one vector per node, one rest length per link.
    void compute(std::span<const double> rest_lengths, std::span<const Vec2<T>> position,
                 std::span<const Vec2<T>> velocity, std::span<Vec2<T>> forces);

    /// One family each, added to `forces`.
    void add_springs(std::span<const double> rest_lengths, std::span<const Vec2<T>> position,
                     std::span<const Vec2<T>> velocity, std::span<Vec2<T>> forces) const;
    void add_pressure(std::span<const Vec2<T>> position, std::span<Vec2<T>> forces) const;
    void add_drag(std::span<const Vec2<T>> position, std::span<const Vec2<T>> velocity,
                  std::span<Vec2<T>> forces) const;
    void add_contact(std::span<const Vec2<T>> position, std::span<Vec2<T>> forces);

  private:
    const SoftBodyModel *model_ = nullptr;
    const Environment *environment_ = nullptr;
    std::vector<Pressure<T>> pressure_; // per triangle
    SelfContact<T> contact_;
};

} // namespace planula
