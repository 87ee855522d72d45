// SPDX-License-Identifier: MIT
// Delaunay triangulation of points in the plane, by CGAL's exact predicates (§2.1). The result is a function
// of the coordinates alone: cocircular ties are broken by CGAL's symbolic perturbation (lexicographic by x,
// then y), and edges and faces are sorted by index, because their order in CGAL depends on insertion.
#pragma once

#include "base/vec2.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace planula {

struct Triangulation {
    std::vector<std::array<int, 2>> edges; // low index first, ascending
    std::vector<std::array<int, 3>> faces; // counter-clockwise, lowest index first, ascending
};

/// One point: nothing; two: one edge; collinear points: the chain along their line. Points must be finite and
/// pairwise different (InternalError otherwise: CGAL would silently lose a vertex).
Triangulation delaunay(std::span<const Vec2d> points);

/// The triangulation of points that move: kept as long as it is right, and mended by flips.
class MovingDelaunay {
  public:
    MovingDelaunay();
    ~MovingDelaunay();

    /// Of new points; as delaunay().
    void start(std::span<const Vec2d> points);
    /// The same points at new, finite places, and any number of points more: as delaunay() of them, sooner.
    /// False if points have moved so far past each other that a few exchanged edges do not mend it, there are no faces or
    /// points coincide, so that it must be started again; then points may coincide, else they do not.
    bool follow(std::span<const Vec2d> points);

    const Triangulation &now() const { return now_; }
    /// False only if edges and faces are those before the last start() or follow().
    bool has_changed() const { return changed_; }

  private:
    struct Mesh; // of CGAL
    std::unique_ptr<Mesh> mesh_;
    Triangulation now_;
    bool changed_ = false;
};

} // namespace planula
