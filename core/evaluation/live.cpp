// SPDX-License-Identifier: MIT
#include "evaluation/live.h"

#include "development/grow.h"
#include "locomotion/trial.h"
#include "network/network.h"
#include "physics/embody.h"
#include "physics/native/native_engine.h"

#include <utility>

namespace planula {

namespace {

/// What growth alone decides of a life.
Life life_of(const Growth &growth) {
    Life life;
    life.outcome = growth.outcome;
    life.cells = growth.cells;
    life.largest = growth.largest;
    life.births = growth.births;
    life.links = static_cast<int>(growth.body.mesh.links.size());
    life.triangles = static_cast<int>(growth.body.mesh.triangles.size());
    life.elongation = elongation(growth.body.positions);
    return life;
}

} // namespace

Life live(const Genome &genome, Actuation actuation, double actuation_range, const Environment &environment,
          const Parameters &parameters, const Watch &watch) {
    const Network network = express(genome, parameters.propagation_limit);
    const Growth growth = grow(network, actuation, parameters, watch.grow);
    Life life = life_of(growth);
    if (growth.outcome != Outcome::viable) return life;
    if (watch.born) watch.born(growth.body);

    const SoftBodyModel model = embody(growth.body, environment, parameters);
    const auto gait = make_gait(actuation, network, growth.body, growth.tissue, parameters);
    NativeEngine engine;
    Trial trial = locomote(model, environment, actuation_range, *gait, engine, watch.move);

    // A life that ended early has no place and no distance.
    life.outcome = trial.outcome;
    life.settle_steps = trial.settle_steps;
    if (trial.outcome != Outcome::viable) return life;
    life.rest = trial.rest;
    life.end = trial.end;
    life.activity = trial.activity;
    life.path = std::move(trial.path);
    return life;
}

} // namespace planula
