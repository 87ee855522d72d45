// SPDX-License-Identifier: MIT
#include "locomotion/trial.h"

#include "body/body.h"
#include "locomotion/last_quarter.h"

#include <cmath>
#include <numeric>
#include <vector>

namespace planula {

namespace {

/// Muscles off until all nodes have been slow for settle_window steps in a row (§2.5).
Outcome settle(const SettlingParameters &p, Engine &engine, int &steps) {
    int calm = 0;
    for (steps = 0; steps < p.settle_limit && calm < p.settle_window; ++steps) {
        const Motion motion = engine.step(p.settle_damping);
        if (motion.exploded) return Outcome::exploded;
        calm = motion.fastest < p.settle_speed ? calm + 1 : 0;
    }
    return calm < p.settle_window ? Outcome::never_settled : Outcome::viable;
}

/// The cells' muscles at knots, handed to the engine one knot ahead.
class Muscles {
  public:
    Muscles(const GaitParameters &parameters, double range, int cells, Gait &gait, const Engine &engine)
        : parameters_(parameters), range_(range), gait_(gait), from_(cells), to_(cells), now_(cells),
          extensions_(cells), changes_(cells) {
        read(0, engine);
    }

    /// On the way to the knot at t, for which the gait senses where the cells are now.
    void reach(int t, int steps, Engine &engine) {
        from_.swap(to_);
        read(t, engine);
        const double share = ramp(t, parameters_);
        for (std::size_t i = 0; i < to_.size(); ++i) {
            extensions_[i] = extension(range_, share, to_[i]);
            changes_[i] += std::abs(to_[i] - from_[i]);
        }
        engine.actuate(extensions_, steps);
    }
    /// Of all cells, at the coming knot.
    std::span<const double> extensions() const { return extensions_; }
    /// By how much all signals have changed from knot to knot so far.
    double change() const { return std::accumulate(changes_.begin(), changes_.end(), 0.0); }
    /// The signals at this share of the way.
    std::span<const double> signals(double share) {
        for (std::size_t i = 0; i < now_.size(); ++i) now_[i] = from_[i] + share * (to_[i] - from_[i]);
        return now_;
    }

  private:
    void read(int t, const Engine &engine) {
        if (gait_.senses()) gait_.sense(engine.positions());
        gait_.signals(t, to_);
    }

    const GaitParameters &parameters_;
    double range_;
    Gait &gait_;
    std::vector<double> from_, to_, now_, extensions_, changes_; // per cell
};

} // namespace

Trial locomote(const SoftBodyModel &model, const Environment &environment, double actuation_range,
               const Parameters &parameters, Gait &gait, Engine &engine, const MoveWatch &watch,
               TrialObserver *observer) {
    const GaitParameters &p = parameters.gait;
    Trial trial;
    engine.load(model, environment);
    if (environment.gravity > 0) {
        trial.outcome = settle(parameters.settling, engine, trial.settle_steps);
        if (trial.outcome != Outcome::viable) return trial;
    }
    trial.rest = centre_of_mass(engine.positions());
    trial.path.push_back(trial.rest);

    // Step n uses the rest lengths of t = n + 1: exact at knots, linear between them. At t = 0 the ramp is 0.
    Muscles muscles(p, actuation_range, model.nodes(), gait, engine);
    const int late = last_quarter(p.locomotion_steps, p.knot_interval);
    double before = 0; // change of signals before it
    if (watch) watch(0, engine.positions(), muscles.signals(1));
    if (observer) observer->begin(model, environment, engine, muscles.signals(1));
    for (int start = 0; start < p.locomotion_steps; start += p.knot_interval) {
        if (start == late) before = muscles.change();
        muscles.reach(start + p.knot_interval, p.knot_interval, engine);
        if (observer) observer->actuate(muscles.extensions(), p.knot_interval);
        for (int j = 1; j <= p.knot_interval; ++j) {
            const Motion motion = engine.step(0);
            if (motion.exploded || !gait.is_sound()) {
                trial.outcome = Outcome::exploded;
                return trial;
            }
            const int t = start + j;
            if (t % p.path_interval == 0) trial.path.push_back(centre_of_mass(engine.positions()));
            const double share = static_cast<double>(j) / p.knot_interval;
            if (watch) watch(t, engine.positions(), muscles.signals(share));
            if (observer) observer->step(t, engine, muscles.signals(share));
        }
    }
    trial.finish = centre_of_mass(engine.positions());
    trial.activity = gait.activity();
    const double change = muscles.change();
    trial.late_actuation = change > 0 ? (change - before) / change : 0;
    return trial;
}

} // namespace planula
