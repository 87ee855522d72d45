// SPDX-License-Identifier: MIT
#include "evaluation/cyclic_gait.h"

#include "locomotion/last_quarter.h"

#include <algorithm>
#include <cstddef>

namespace planula {

double late_share(const Life &life, const GaitParameters &gait) {
    const double displacement = life.displacement();
    const int interval = gait.path_interval;
    const auto sample = static_cast<std::size_t>(last_quarter(gait.locomotion_steps, interval) / interval);
    if (displacement == 0 || sample >= life.path.size()) return 0;
    return length(life.finish - life.path[sample]) / displacement;
}

bool is_cyclic(double late_share, double late_actuation, double level) {
    return std::min(late_share, late_actuation) >= level;
}

} // namespace planula
