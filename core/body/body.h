// SPDX-License-Identifier: MIT
// The finished morphology, constant: what development hands to physics (§2.5; rule B1; decisions 0006 to 0010). All
// measures are taken from the one triangulation at the end of development, so the body is in equilibrium there.
#pragma once

#include "body/mesh.h"

namespace planula {

struct Body {
    std::vector<Vec2d> positions; // development frame, one per cell
    Mesh mesh;
    std::vector<double> rest_lengths; // per link
    std::vector<double> areas;        // per triangle, > 0
    std::vector<OutlineLink> outline;

    int cells() const { return static_cast<int>(positions.size()); }
};

/// The body over these cell centres, finite and pairwise different, with their mesh: connect().
Body make_body(std::vector<Vec2d> positions, Mesh mesh);
Body make_body(std::vector<Vec2d> positions, double link_limit);

/// Mean of points, summed in index order; (0, 0) of none.
Vec2d centre_of_mass(std::span<const Vec2d> points);

/// The largest speed of a point relative to the motion of all as one rigid body: its mean velocity, and its mean
/// turn about the centre. 0 of none.
double unrest(std::span<const Vec2d> points, std::span<const Vec2d> velocities);

/// Length over width by the principal axes of the cell centres, >= 1: sqrt of the ratio of their variances,
/// capped at 1000 for a chain; 0 for fewer than three cells.
double elongation(std::span<const Vec2d> positions);

} // namespace planula
