// SPDX-License-Identifier: MIT
// The soft body as every engine loads it, constant: point masses of mass 1 at the cells, springs along the
// links, pressure in the triangles, and who may collide with what (§2.5; decisions 0006 to 0010).
#pragma once

#include "body/mesh.h"
#include "parameters/parameters.h"

namespace planula {

struct SoftBodyModel {
    std::vector<Vec2d> positions; // world frame, at rest
    std::vector<Link> links;
    std::vector<double> rest_lengths; // per link, without actuation
    std::vector<Triangle> triangles;
    std::vector<double> areas; // per triangle, in equilibrium
    std::vector<OutlineLink> outline;

    // Self-collision: the cells on the outline of solid parts meet its solid links, unless masked.
    std::vector<int> contact_cells; // ascending
    std::vector<char> masked;       // contact_cells × outline, a row per contact cell

    BodyParameters body;  // the numbers of the laws
    double time_step = 0; // length of a step, t.u.
    int object_nodes = 0; // of a loose object: the last nodes

    int nodes() const { return static_cast<int>(positions.size()); }
    /// The nodes of the animat itself: the first ones.
    int cells() const { return nodes() - object_nodes; }
    bool is_masked(std::size_t contact_cell, std::size_t outline_link) const {
        return masked[contact_cell * outline.size() + outline_link] != 0;
    }
};

/// Where the nodes of a body are and how they move, world frame: one each.
struct BodyState {
    std::vector<Vec2d> positions, velocities;
};

/// The body at rest where the model has it.
inline BodyState at_rest(const SoftBodyModel &model) {
    return {model.positions, std::vector<Vec2d>(model.positions.size())};
}

} // namespace planula
