// SPDX-License-Identifier: MIT
#include "evaluation/live.h"

#include "base/hash.h"
#include "development/grow.h"
#include "device/device.h"
#include "evaluation/life_observer.h"
#include "locomotion/trial.h"
#include "network/network.h"
#include "physics/embody.h"
#include "physics/engine.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace planula {

namespace {

/// What growth alone decides of a life.
Life life_of(const Growth &growth, const Conditions &conditions) {
    Life life;
    life.observations.known = conditions.observed;
    if (conditions.observed.has(Observation::body)) life.observations.body = growth.body.positions;
    life.outcome = growth.outcome;
    life.cells = growth.cells;
    life.largest = growth.largest;
    life.births = growth.births;
    life.springs = static_cast<int>(growth.body.mesh.links.size());
    life.triangles = static_cast<int>(growth.body.mesh.triangles.size());
    life.elongation = elongation(growth.body.positions);
    if (growth.outcome == Outcome::viable) life.shape = shape_distribution(growth.body.positions);
    return life;
}

/// A number in [-1, 1) that depends on `value` alone.
double hashed(std::uint64_t value) { return static_cast<double>(mix(value) >> 11) * 0x1p-52 - 1; }

void disturb(const Nudge &nudge, std::vector<Vec2d> &positions) {
    if (nudge.reach == 0) return;
    std::uint64_t place = mix(static_cast<std::uint64_t>(nudge.number));
    for (Vec2d &position : positions) {
        const double right = hashed(place + 1), up = hashed(place + 2);
        position += Vec2d{right, up} * nudge.reach;
        place += 2;
    }
}

/// Copies what locomotion decides of a life from one with the same locomotion.
void copy_locomotion(const Life &known, Life &life) {
    life.outcome = known.outcome;
#define FIELD(type, name, initial, unit, stage, meaning)                                                     \
    if (KnownAfter::stage == KnownAfter::locomotion) life.name = known.name;
#include "evaluation/life.inl"
#define OBSERVATION(type, name, initial, unit, stage, exists, meaning)                                       \
    if (KnownAfter::stage == KnownAfter::locomotion) life.observations.name = known.observations.name;
#include "evaluation/observations.inl"
}

void observe_object(const Trial &trial, Observations &observations) {
    if (observations.known.has(Observation::object_rest) && trial.object_rest)
        observations.object_rest = *trial.object_rest;
    if (observations.known.has(Observation::object_finish) && trial.object_finish)
        observations.object_finish = *trial.object_finish;
}

/// What a body did in each of several worlds, as far as it was asked for.
void tell_phases(std::span<const PhaseResult> phases, Observations &observations) {
    const ObservationSet &asked = observations.known;
    for (const auto &[steps, settle_steps, start, finish] : phases) {
        if (asked.has(Observation::phase_start)) observations.phase_start.push_back(start);
        if (asked.has(Observation::phase_finish)) observations.phase_finish.push_back(finish);
        if (asked.has(Observation::phase_steps)) observations.phase_steps.push_back(steps);
        if (asked.has(Observation::phase_settle_steps))
            observations.phase_settle_steps.push_back(settle_steps);
    }
}

/// What the trial of a gait calls.
MoveWatch watch_of(const Watch &watch, const Gait &gait) {
    if (!watch.move && !watch.update) return {};
    return [&](int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
        if (watch.move) watch.move(step, nodes, signal);
        if (watch.update && gait.activations()) watch.update(step, *gait.activations());
    };
}

/// What a body does, nobody watching: on the chosen device, if there is one and it simulates such trials, or here.
Trial unwatched_trial(const SoftBodyModel &model, const Conditions &conditions, const Parameters &moving,
                      Gait &gait) {
    const Environment &environment = conditions.environment;
    if (Device *device = chosen_device(); device && conditions.engine == "native")
        if (auto trial = device->locomote(model, environment, conditions.actuation_range, moving, gait))
            return std::move(*trial);
    const auto engine = make_engine(conditions.engine);
    return locomote(model, environment, conditions.actuation_range, moving, gait, *engine);
}

/// Lets a body settle and move: what locomotion decides of its life.
void move(const Network &network, const Growth &growth, const Conditions &conditions, const Watch &watch,
          const Loss *loss, Life &life) {
    const Parameters moving = refined(conditions.parameters, conditions.refinement);
    SoftBodyModel model =
        embody(growth.body, conditions.environment, moving.body, moving.development.time_step);
    disturb(conditions.nudge, model.positions);
    auto gait = make_gait(conditions.actuation, network, growth.body, growth.tissue, moving);
    if (conditions.held_from) gait = hold(std::move(gait), *conditions.held_from * conditions.refinement);
    std::optional<LifeObserver> observer;
    if (!conditions.observed.empty()) observer.emplace(conditions.observed, moving);
    const MoveWatch move_watch = watch_of(watch, *gait);
    Trial trial;
    if (move_watch || observer || loss || !conditions.phases.empty()) {
        const auto engine = make_engine(conditions.engine);
        trial = locomote(model, conditions.environment, conditions.actuation_range, moving, *gait, *engine,
                         move_watch, observer ? &*observer : nullptr,
                         {conditions.phases, loss, conditions.refinement});
    } else {
        trial = unwatched_trial(model, conditions, moving, *gait);
    }

    // Of locomotion that ended early neither place nor distance is known.
    life.outcome = trial.outcome;
    life.settle_steps = trial.settle_steps;
    if (trial.outcome != Outcome::viable) return;
    life.rest = trial.rest;
    life.finish = trial.finish;
    life.activity = trial.activity;
    life.late_actuation = trial.late_actuation;
    life.path = std::move(trial.path);
    if (!observer) return;
    observer->finish(life.observations);
    tell_phases(trial.phases, life.observations);
    observe_object(trial, life.observations);
}

/// The same of a body that loses cells, at first or on its way. Of too few cells that are left nothing is simulated.
void move_damaged(const Network &network, const Growth &growth, const Conditions &conditions,
                  const Watch &watch, Life &life) {
    const Damage &damage = *conditions.damage;
    const std::vector<int> kept = cells_left(growth.body, damage);
    if (static_cast<int>(kept.size()) < conditions.parameters.development.minimum_cells) {
        life.outcome = Outcome::too_small;
        return;
    }
    Growth left{.body = part_of(growth.body, kept), .tissue = growth.tissue};
    left.tissue.keep(kept);
    const auto show = [&] {
        if (watch.born) watch.born(left.body);
    };
    if (damage.at == 0) {
        show();
        return move(network, left, conditions, watch, nullptr, life);
    }
    const Parameters moving = refined(conditions.parameters, conditions.refinement);
    const Loss loss{damage.at, kept,
                    embody(left.body, conditions.environment, moving.body, moving.development.time_step)};
    Watch shown = watch;
    if (watch.move)
        shown.move = [&](int step, std::span<const Vec2d> nodes, std::span<const double> signal) {
            if (step == damage.at * conditions.refinement + 1) show();
            watch.move(step, nodes, signal);
        };
    move(network, growth, conditions, shown, &loss, life);
}

} // namespace

Life live(const Genome &genome, const Conditions &conditions, const Watch &watch, const Recall &recall) {
    const Parameters &growing = conditions.parameters;
    const Network network = express(genome, growing.network.propagation_limit);
    const Growth growth = grow(network, conditions.actuation, growing, watch.grow);
    Life life = life_of(growth, conditions);
    if (growth.outcome != Outcome::viable) return life;
    if (watch.born) watch.born(growth.body);

    const Parameters moving = refined(growing, conditions.refinement);
    if (recall && conditions.actuation == Actuation::oscillator)
        if (const Life *known =
                recall(growth.body.positions, read_oscillators(network, growth.tissue, moving.gait))) {
            copy_locomotion(*known, life);
            return life;
        }

    if (conditions.damage)
        move_damaged(network, growth, conditions, watch, life);
    else
        move(network, growth, conditions, watch, nullptr, life);
    return life;
}

Life develop(const Genome &genome, const Conditions &conditions) {
    const Network network = express(genome, conditions.parameters.network.propagation_limit);
    return life_of(grow(network, conditions.actuation, conditions.parameters), conditions);
}

} // namespace planula
