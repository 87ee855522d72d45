// SPDX-License-Identifier: MIT
#include "development/tissue_forces.h"

#include "base/lanes.h"

namespace planula {

namespace {

/// Adds the forces of `T::width` links to those on their ends.
template <class T>
void add_pulls(const Embryo &embryo, const Link *links, const DevelopmentParameters &p, Vec2d *forces) {
    const auto of_each = [&](const auto &difference) {
        return load_each<T>(
            [&](int lane) { return difference(embryo.cells[links[lane].a], embryo.cells[links[lane].b]); });
    };
    const Vec2<T> offset{of_each([](const Cell &a, const Cell &b) { return b.position.x - a.position.x; }),
                         of_each([](const Cell &a, const Cell &b) { return b.position.y - a.position.y; })};
    const Vec2<T> speed{of_each([](const Cell &a, const Cell &b) { return b.velocity.x - a.velocity.x; }),
                        of_each([](const Cell &a, const Cell &b) { return b.velocity.y - a.velocity.y; })};

    const T l = sqrt(squared_length(offset));
    const Vec2<T> along = offset / l;
    const T tension =
        T(p.tissue_stiffness) * (l - T(2 * p.cell_radius)) + T(p.tissue_damping) * dot(speed, along);
    const T none(0);
    const Vec2<T> pull = select(l <= none, Vec2<T>{none, none}, along * tension);

    double x[T::width], y[T::width];
    store(pull.x, x), store(pull.y, y);
    for (int lane = 0; lane < T::width; ++lane) {
        forces[links[lane].a] += {x[lane], y[lane]};
        forces[links[lane].b] -= {x[lane], y[lane]};
    }
}

} // namespace

std::vector<Vec2d> tissue_forces(const Embryo &embryo, const DevelopmentParameters &p) {
    std::vector<Vec2d> forces(embryo.cells.size());
    for (std::size_t i = 0; i < forces.size(); ++i)
        forces[i] = embryo.cells[i].velocity * -p.tissue_viscosity;

    using Several = DoubleLanes<baseline_doubles>;
    const Link *link = embryo.links.data(), *const end = link + embryo.links.size();
    for (; end - link >= Several::width; link += Several::width)
        add_pulls<Several>(embryo, link, p, forces.data());
    for (; link != end; ++link) add_pulls<DoubleLanes<1>>(embryo, link, p, forces.data());
    return forces;
}

void relax(const DevelopmentParameters &p, Embryo &embryo) {
    const std::vector<Vec2d> forces = tissue_forces(embryo, p);
    const double limit = p.cell_speed_limit / p.time_step, surely_below = 0.999 * limit * limit;
    for (std::size_t i = 0; i < embryo.cells.size(); ++i) {
        Cell &cell = embryo.cells[i];
        cell.velocity += forces[i] * p.time_step;
        if (!(squared_length(cell.velocity) < surely_below)) {
            const double speed = length(cell.velocity);
            if (speed > limit) cell.velocity = cell.velocity * (limit / speed);
        }
        cell.position += cell.velocity * p.time_step;
    }
}

} // namespace planula
