// SPDX-License-Identifier: MIT
#include "evaluation/example_life.h"

#include <cstddef>
#include <vector>

namespace planula {

namespace {

/// An observation of a body of `cells` cells, whose path has so many points.
void fill(double &value, std::size_t, std::size_t) { value = 1.25; }
[[maybe_unused]] void fill(Vec2d &value, std::size_t, std::size_t) { value = {10, 1.5}; }
void fill(std::vector<double> &value, std::size_t cells, std::size_t) { value.assign(cells, 0.25); }
void fill(std::vector<Vec2d> &value, std::size_t cells, std::size_t) {
    for (std::size_t i = 0; i < cells; ++i) value.push_back({static_cast<double>(i) / 4, 1.5});
}
void fill(Samples &value, std::size_t cells, std::size_t points) {
    value.assign(points, std::vector<double>(cells, 0.25));
}

void fill(KnownAfter stage, std::size_t points, Life &life) {
    each_observation(life.observations.known, life.observations, [&](Observation one, auto &value) {
        if (observation_rows()[static_cast<std::size_t>(one)].known == stage)
            fill(value, static_cast<std::size_t>(life.cells), points);
    });
}

} // namespace

Life example_life(Outcome outcome, KnownAfter stage, const Parameters &parameters,
                  const ObservationSet &observed) {
    Life life;
    life.outcome = outcome;
    life.observations.known = observed;
    const bool grew = outcome != Outcome::died_out && outcome != Outcome::too_small;
    life.cells = grew ? 4 * parameters.development.minimum_cells : 0;
    life.largest = outcome == Outcome::overgrown ? parameters.development.cell_limit : life.cells;
    life.births = life.largest + 1;
    if (outcome != Outcome::viable) return life;
    life.springs = 2 * life.cells;
    life.triangles = life.cells + 1;
    life.elongation = 2;
    fill(KnownAfter::growth, 0, life);
    if (stage == KnownAfter::growth) return life;
    life.settle_steps = 2 * parameters.settling.settle_window;
    life.rest = {0, 1};
    life.finish = {10, 1.5};
    life.activity = life.late_actuation = 0.25;
    const int points = parameters.gait.locomotion_steps / parameters.gait.path_interval;
    for (int i = 0; i <= points; ++i)
        life.path.push_back(life.rest +
                            (life.finish - life.rest) * (points ? i / static_cast<double>(points) : 1.0));
    fill(KnownAfter::locomotion, life.path.size(), life);
    return life;
}

} // namespace planula
