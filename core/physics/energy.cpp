// SPDX-License-Identifier: MIT
#include "physics/energy.h"

#include <algorithm>

namespace planula {

double elastic_energy(const SoftBodyModel &model, std::span<const double> rest_lengths,
                      std::span<const Vec2d> x) {
    const BodyParameters &p = model.body;
    double sum = 0;
    for (std::size_t i = 0; i < model.links.size(); ++i) {
        const double stretch = length(x[model.links[i].b] - x[model.links[i].a]) - rest_lengths[i];
        sum += 0.5 * p.spring_stiffness * stretch * stretch;
    }
    for (std::size_t i = 0; i < model.triangles.size(); ++i) {
        const auto [a, b, c] = model.triangles[i];
        const double loss = model.areas[i] - 0.5 * cross(x[b] - x[a], x[c] - x[a]);
        sum += 0.5 * p.pressure_stiffness / std::max(model.areas[i], p.area_floor) * loss * loss;
    }
    return sum;
}

} // namespace planula
