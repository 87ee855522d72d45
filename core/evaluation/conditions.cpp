// SPDX-License-Identifier: MIT
#include "evaluation/conditions.h"

namespace planula {

Parameters refined(Parameters p, int refinement) {
    p.time_step /= refinement;
    p.node_speed_limit /= refinement;
    for (int *steps : {&p.settle_window, &p.settle_limit, &p.locomotion_steps, &p.ramp_steps,
                       &p.knot_interval, &p.update_interval, &p.path_interval})
        *steps *= refinement;
    p.period_shortest *= refinement;
    p.period_longest *= refinement;
    return p;
}

} // namespace planula
