// SPDX-License-Identifier: MIT
#include "cell/senses.h"

#include "base/math.h"

namespace planula {

std::array<double, input::count> sense(Vec2d position, double morphogen, double time,
                                       const NetworkParameters &p) {
    const double d = p.morphogen_distance;
    const auto maternal = [&](Vec2d source) {
        return math::exp(-length(position - source) / p.morphogen_decay);
    };
    std::array<double, input::count> inputs;
    inputs[input::x] = position.x / p.position_scale;
    inputs[input::y] = position.y / p.position_scale;
    inputs[input::maternal_east] = maternal({d, 0});
    inputs[input::maternal_west] = maternal({-d, 0});
    inputs[input::maternal_north] = maternal({0, d});
    inputs[input::maternal_south] = maternal({0, -d});
    inputs[input::morphogen] = morphogen;
    inputs[input::time] = time;
    inputs[input::bias] = 1;
    return inputs;
}

} // namespace planula
