// SPDX-License-Identifier: MIT
// The forces on the nodes of one soft body, a family at a time, in double precision (§2.5; decisions 0006 to 0009).
// Plain loops over springs, triangles, outline and pairs, in the order in which the body has them, so that every sum
// depends on the body alone. The laws are in physics/laws/. Gravity, ground and walls are the engine's own.
#pragma once

#include "physics/environment.h"
#include "physics/soft_body.h"
#include "physics/surroundings.h"
#include "physics/walls.h"

#include <span>
#include <vector>

namespace planula::reference {

using Nodes = BodyState;

/// The fields of an environment, world frame.
struct Surroundings {
    Fluid<double> open; // outside of all regions
    std::vector<FluidRegion<double>> regions;
    Vec2d gravity;
    std::vector<Layer<double>> water; // that carries a body

    Surroundings() = default;
    Surroundings(const Environment &environment) : Surroundings(environment, environment.flow_at(0)) {}
    /// With this flow where no region has its own.
    Surroundings(const Environment &environment, Vec2d flow);
    Fluid<double> fluid(Vec2d place) const {
        return fluid_at(place, open, regions.data(), static_cast<int>(regions.size()));
    }
    /// The acceleration by gravity.
    Vec2d fall(Vec2d place) const {
        return gravity * gravity_share(place.y, water.data(), static_cast<int>(water.size()));
    }
};

/// All families at this state but the pull of walls, a vector for each node. `rest_lengths`: one for each link.
std::vector<Vec2d> forces_on(const SoftBodyModel &model, const Surroundings &surroundings,
                             std::span<const double> rest_lengths, const Nodes &nodes);

/// One family each, added to `forces`.
void add_springs(const SoftBodyModel &model, std::span<const double> rest_lengths, const Nodes &nodes,
                 std::span<Vec2d> forces);
void add_pressure(const SoftBodyModel &model, std::span<const Vec2d> positions, std::span<Vec2d> forces);
void add_contact(const SoftBodyModel &model, std::span<const Vec2d> positions, std::span<Vec2d> forces);
/// Of links that walls have pierced; walls count from `origin`.
void add_pull_of_walls(const SoftBodyModel &model, const WallsView<double> &walls, Vec2d origin,
                       std::span<const Vec2d> positions, std::span<Vec2d> forces);
void add_drag(const SoftBodyModel &model, const Surroundings &surroundings, const Nodes &nodes,
              std::span<Vec2d> forces);

} // namespace planula::reference
