// SPDX-License-Identifier: MIT
// The neighbourhood of cells, in embryos and in bodies (§2.1; decision 0004): the Delaunay triangulation
// without links longer than 150 % of a cell diameter, except where such a link holds the body together.
#pragma once

#include "body/mesh.h"
#include "geometry/moving_delaunay.h"

namespace planula {

/// Links: all of length <= `limit`; then, in ascending order of length (ties by index), each longer Delaunay
/// link whose ends are not yet connected. Triangles: the Delaunay faces whose three links are all kept.
/// Positions must be finite and pairwise different; check with has_coincident_points.
Mesh connect(std::span<const Vec2d> positions, double limit);

/// The same while cells move, in less time.
class Connection {
  public:
    explicit Connection(double limit) : limit_(limit) {}

    /// Of new cells.
    void start(std::span<const Vec2d> positions);
    /// Of the same cells at new, finite places, and any number of cells more. False if start() must be called
    /// again; then cells may coincide.
    bool follow(std::span<const Vec2d> positions);

    const std::vector<Link> &links() const { return links_; }
    /// Whether links differ from those before the last start() or follow().
    bool has_changed() const { return changed_; }
    Mesh mesh() const;

  private:
    void connect_all(std::span<const Vec2d> positions);

    double limit_;
    MovingDelaunay delaunay_;
    std::vector<Link> links_;
    std::vector<char> short_; // per edge of the triangulation
    std::size_t cells_ = 0;
    bool all_short_ = false; // whether no link is longer than the limit
    bool changed_ = false;
};

/// Whether two points have equal coordinates, so that no triangulation has a place for both.
bool has_coincident_points(std::span<const Vec2d> positions);

} // namespace planula
