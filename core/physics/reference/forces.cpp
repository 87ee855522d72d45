// SPDX-License-Identifier: MIT
#include "physics/reference/forces.h"

#include "physics/laws/contact.h"
#include "physics/laws/drag.h"
#include "physics/laws/pressure.h"
#include "physics/laws/spring.h"

namespace planula::reference {

Surroundings::Surroundings(const Environment &environment, Vec2d flow)
    : open{environment.drag_normal, environment.drag_tangential, flow},
      regions(lay_regions<double>(environment, flow, {})),
      gravity(gravity_vector(environment.gravity, environment.gravity_direction)),
      water(lay_water<double>(environment, {})) {}

std::vector<Vec2d> forces_on(const SoftBodyModel &model, const Surroundings &surroundings,
                             std::span<const double> rest_lengths, const Nodes &nodes) {
    std::vector<Vec2d> forces(nodes.positions.size());
    add_springs(model, rest_lengths, nodes, forces);
    add_pressure(model, nodes.positions, forces);
    add_drag(model, surroundings, nodes, forces);
    add_contact(model, nodes.positions, forces);
    return forces;
}

// Rule B3.
void add_springs(const SoftBodyModel &model, std::span<const double> rest_lengths, const Nodes &nodes,
                 std::span<Vec2d> forces) {
    const auto &[x, v] = nodes;
    const double k = model.body.spring_stiffness, c = model.body.spring_damping;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
        const auto [a, b] = model.links[i];
        const Vec2d force = spring_force(spring_to(x[b] - x[a], v[b] - v[a]), k, k * rest_lengths[i], c);
        forces[a] += force;
        forces[b] -= force;
    }
}

// Rule B4.
void add_pressure(const SoftBodyModel &model, std::span<const Vec2d> x, std::span<Vec2d> forces) {
    const double stiffness = model.body.pressure_stiffness, floor = model.body.area_floor;
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        const auto [a, b, c] = model.triangles[i];
        const auto pressure = pressure_of<double>(model.areas[i], stiffness, floor);
        forces[a] += pressure_force(x[b] - x[a], x[c] - x[a], pressure);
        forces[b] += pressure_force(x[c] - x[b], x[a] - x[b], pressure);
        forces[c] += pressure_force(x[a] - x[c], x[b] - x[c], pressure);
    }
}

// Rule B5: all pairs of a cell and a link of the outline, but those that never push.
void add_contact(const SoftBodyModel &model, std::span<const Vec2d> x, std::span<Vec2d> forces) {
    const double stiffness = model.body.contact_stiffness, radius = model.body.contact_radius;
    for (std::size_t i = 0; i < model.contact_cells.size(); ++i)
        for (std::size_t j = 0; j < model.outline.size(); ++j) {
            if (model.is_masked(i, j)) continue;
            const int cell = model.contact_cells[i], a = model.outline[j].a, b = model.outline[j].b;
            const auto [on_cell, on_a, on_b] = contact_forces(x[cell], x[a], x[b], stiffness, radius);
            forces[cell] += on_cell;
            forces[a] += on_a;
            forces[b] += on_b;
        }
}

// Decision 0024.
void add_pull_of_walls(const SoftBodyModel &model, const WallsView<double> &walls, Vec2d origin,
                       std::span<const Vec2d> x, std::span<Vec2d> forces) {
    pull_outline(
        walls, model.outline, model.body.contact_stiffness, [&](int node) { return x[node] - origin; },
        [&](int node, Vec2d force) { forces[node] += force; });
}

// Rule W2, with the fluid at the middle of a link.
void add_drag(const SoftBodyModel &model, const Surroundings &surroundings, const Nodes &nodes,
              std::span<Vec2d> forces) {
    const auto &[x, v] = nodes;
    for (const OutlineLink &link : model.outline) {
        const Fluid<double> fluid = surroundings.fluid((x[link.a] + x[link.b]) * 0.5);
        if (fluid.normal == 0 && fluid.tangential == 0) continue;
        const Vec2d through = (v[link.a] + v[link.b]) * 0.5 - fluid.flow;
        const Vec2d drag = drag_force(x[link.b] - x[link.a], through, fluid.normal, fluid.tangential);
        forces[link.a] += drag * 0.5;
        forces[link.b] += drag * 0.5;
    }
}

} // namespace planula::reference
