// SPDX-License-Identifier: MIT
// The forces on the nodes of one soft body, a family at a time, in double precision (§2.5; decisions 0006 to 0009).
// Plain loops over springs, triangles, outline and pairs, in the order in which the body has them, so that every sum
// depends on the body alone. The laws are in physics/laws/. Gravity and the ground are the engine's own.
#pragma once

#include "physics/environment.h"
#include "physics/soft_body.h"

#include <span>
#include <vector>

namespace planula::reference {

/// Where the nodes are and how they move, one vector each.
struct Nodes {
    std::vector<Vec2d> positions, velocities;
};

/// All families at this state, a vector for each node. `rest_lengths`: one for each link.
std::vector<Vec2d> forces_on(const SoftBodyModel &model, const Environment &environment,
                             std::span<const double> rest_lengths, const Nodes &nodes);

/// One family each, added to `forces`.
void add_springs(const SoftBodyModel &model, std::span<const double> rest_lengths, const Nodes &nodes,
                 std::span<Vec2d> forces);
void add_pressure(const SoftBodyModel &model, std::span<const Vec2d> positions, std::span<Vec2d> forces);
void add_contact(const SoftBodyModel &model, std::span<const Vec2d> positions, std::span<Vec2d> forces);
void add_drag(const SoftBodyModel &model, const Environment &environment, const Nodes &nodes,
              std::span<Vec2d> forces);

} // namespace planula::reference
