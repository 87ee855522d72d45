// SPDX-License-Identifier: MIT
#include "locomotion/trial.h"

#include "body/body.h"

#include <utility>

namespace planula {

namespace {

/// Muscles off until all nodes have been slow for settle_window steps in a row (§2.5).
Outcome settle(const SoftBodyModel &model, Engine &engine, int &steps) {
    const Parameters &p = model.parameters;
    int calm = 0;
    for (steps = 0; steps < p.settle_limit && calm < p.settle_window; ++steps) {
        const Motion motion = engine.step(model.rest_lengths, p.settle_damping);
        if (motion.exploded) return Outcome::exploded;
        calm = motion.fastest < p.settle_speed ? calm + 1 : 0;
    }
    return calm < p.settle_window ? Outcome::never_settled : Outcome::viable;
}

/// Signals and rest lengths at one knot.
struct Knot {
    std::vector<double> signal, lengths;
};

Knot make_knot(const SoftBodyModel &model, double range, int t, Gait &gait) {
    Knot knot{std::vector<double>(model.positions.size()), {}};
    gait.signals(t, knot.signal);
    for (std::size_t i = 0; i < model.links.size(); ++i) {
        const auto [a, b] = model.links[i];
        knot.lengths.push_back(actuated_length(model.rest_lengths[i], range, ramp(t, model.parameters),
                                               knot.signal[a], knot.signal[b]));
    }
    return knot;
}

/// The values between two knots, into `result`.
void blend(const std::vector<double> &from, const std::vector<double> &to, double share,
           std::vector<double> &result) {
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = from[i] + share * (to[i] - from[i]);
}

} // namespace

Trial locomote(const SoftBodyModel &model, const Environment &environment, double actuation_range, Gait &gait,
               Engine &engine, const MoveWatch &watch) {
    const Parameters &p = model.parameters;
    Trial trial;
    engine.load(model, environment);
    if (environment.gravity > 0) {
        trial.outcome = settle(model, engine, trial.settle_steps);
        if (trial.outcome != Outcome::viable) return trial;
    }
    trial.rest = centre_of_mass(engine.positions());
    trial.path.push_back(trial.rest);

    // Step n uses the rest lengths of t = n + 1: exact at knots, linear between them.
    Knot from = make_knot(model, actuation_range, 0, gait), now = from;
    if (watch) watch(0, engine.positions(), from.signal);
    for (int start = 0; start < p.locomotion_steps; start += p.knot_interval) {
        Knot to = make_knot(model, actuation_range, start + p.knot_interval, gait);
        for (int j = 1; j <= p.knot_interval; ++j) {
            const double share = static_cast<double>(j) / p.knot_interval;
            blend(from.lengths, to.lengths, share, now.lengths);
            const Motion motion = engine.step(now.lengths, 0);
            if (motion.exploded || !gait.is_sound()) {
                trial.outcome = Outcome::exploded;
                return trial;
            }
            const int t = start + j;
            if (t % p.path_interval == 0) trial.path.push_back(centre_of_mass(engine.positions()));
            if (!watch) continue;
            blend(from.signal, to.signal, share, now.signal);
            watch(t, engine.positions(), now.signal);
        }
        from = std::move(to);
    }
    trial.end = centre_of_mass(engine.positions());
    trial.activity = gait.activity();
    return trial;
}

} // namespace planula
