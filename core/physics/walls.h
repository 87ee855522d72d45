// SPDX-License-Identifier: MIT
// The walls of an environment as the laws of contact read them (laws/wall.h): obstacles, and with them ceiling and
// ground, cut where friction changes (decision 0024). Environments with ground alone have none (ground.h).
#pragma once

#include "physics/environment.h"
#include "physics/laws/wall.h"
#include "physics/soft_body.h"

#include <span>
#include <vector>

namespace planula {

/// T: float or double.
template <class T> class Walls {
  public:
    /// None.
    Walls() = default;
    /// Those of an environment, counted from `origin`.
    Walls(const Environment &environment, Vec2d origin);

    bool empty() const { return walls_.empty(); }
    /// Valid as long as this is there and unchanged.
    WallsView<T> view() const {
        return {walls_.data(), low_, per_square_, columns_, rows_, first_.data(), members_.data()};
    }
    std::span<const Wall<T>> all() const { return walls_; }

  private:
    using Squares = std::vector<std::vector<int>>;
    void make_grid();
    void add_to(Squares &squares, int number, double margin) const;

    std::vector<Wall<T>> walls_;
    Vec2<T> low_;
    double side_ = 0; // of a square
    T per_square_ = 0;
    int columns_ = 0, rows_ = 0;
    std::vector<int> first_, members_;
};

/// A line of ground or ceiling cut at the borders of patches, and the friction of each part, from that left of the first
/// point to that right of the last. An empty line is level, at height 0.
struct CutLine {
    std::vector<Vec2d> points;
    std::vector<double> frictions; // one more than points
};
CutLine cut(const std::vector<Vec2d> &line, const Environment &environment);

/// Calls push(node, force) for what draws links of the outline back that walls have pierced (laws/wall.h: pull_back).
/// Links of chains, which have no inside, are not drawn back.
template <class T>
void pull_outline(const WallsView<T> &walls, std::span<const OutlineLink> outline, T stiffness,
                  const auto &place_of, const auto &push) {
    for (const OutlineLink &link : outline) {
        if (!link.solid) continue;
        const auto [on_a, on_b] = pull_back(walls, place_of(link.a), place_of(link.b), stiffness);
        if (on_a != Vec2<T>{} || on_b != Vec2<T>{}) push(link.a, on_a), push(link.b, on_b);
    }
}

} // namespace planula
