// SPDX-License-Identifier: MIT
#include "evaluation/example_life.h"

namespace planula {

Life example_life(Outcome outcome, KnownAfter stage, const Parameters &parameters) {
    Life life;
    life.outcome = outcome;
    const bool grew = outcome != Outcome::died_out && outcome != Outcome::too_small;
    life.cells = grew ? 4 * parameters.development.minimum_cells : 0;
    life.largest = outcome == Outcome::overgrown ? parameters.development.cell_limit : life.cells;
    life.births = life.largest + 1;
    if (outcome != Outcome::viable) return life;
    life.springs = 2 * life.cells;
    life.triangles = life.cells + 1;
    life.elongation = 2;
    if (stage == KnownAfter::growth) return life;
    life.settle_steps = 2 * parameters.settling.settle_window;
    life.rest = {0, 1};
    life.finish = {10, 1.5};
    life.activity = life.late_actuation = 0.25;
    const int points = parameters.gait.locomotion_steps / parameters.gait.path_interval;
    for (int i = 0; i <= points; ++i)
        life.path.push_back(life.rest +
                            (life.finish - life.rest) * (points ? i / static_cast<double>(points) : 1.0));
    return life;
}

} // namespace planula
