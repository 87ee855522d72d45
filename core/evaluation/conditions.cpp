// SPDX-License-Identifier: MIT
#include "evaluation/conditions.h"

namespace planula {

Parameters refined(Parameters p, int refinement) {
    p.development.time_step /= refinement;
    p.body.node_speed_limit /= refinement;
    for (int *steps :
         {&p.settling.settle_window, &p.settling.settle_limit, &p.gait.locomotion_steps, &p.gait.ramp_steps,
          &p.gait.knot_interval, &p.gait.update_interval, &p.gait.path_interval})
        *steps *= refinement;
    p.gait.period_shortest *= refinement;
    p.gait.period_longest *= refinement;
    return p;
}

} // namespace planula
