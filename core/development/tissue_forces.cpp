// SPDX-License-Identifier: MIT
#include "development/tissue_forces.h"

namespace planula {

std::vector<Vec2d> tissue_forces(const Embryo &embryo, const Parameters &p) {
    std::vector<Vec2d> forces;
    for (const Cell &cell : embryo.cells) forces.push_back(cell.velocity * -p.tissue_viscosity);
    for (const auto &[a, b] : embryo.mesh.links) {
        const Cell &first = embryo.cells[a], &second = embryo.cells[b];
        const Vec2d offset = second.position - first.position;
        const double l = length(offset);
        if (l == 0) continue;
        const Vec2d along = offset / l;
        const double stretching = dot(second.velocity - first.velocity, along);
        const double tension = p.tissue_stiffness * (l - 2 * p.cell_radius) + p.tissue_damping * stretching;
        forces[a] += along * tension;
        forces[b] -= along * tension;
    }
    return forces;
}

void relax(const Parameters &p, Embryo &embryo) {
    const std::vector<Vec2d> forces = tissue_forces(embryo, p);
    const double limit = p.cell_speed_limit / p.time_step;
    for (std::size_t i = 0; i < embryo.cells.size(); ++i) {
        Cell &cell = embryo.cells[i];
        cell.velocity += forces[i] * p.time_step;
        const double speed = length(cell.velocity);
        if (speed > limit) cell.velocity = cell.velocity * (limit / speed);
        cell.position += cell.velocity * p.time_step;
    }
}

} // namespace planula
