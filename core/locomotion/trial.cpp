// SPDX-License-Identifier: MIT
#include "locomotion/trial.h"

#include "base/keep_only.h"
#include "body/body.h"
#include "locomotion/last_quarter.h"
#include "physics/embody.h"
#include "physics/room.h"

#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace planula {

namespace {

/// The fastest of the animat's nodes.
double fastest_cell(const SoftBodyModel &model, const Engine &engine) {
    double fastest = 0;
    const auto velocities = engine.velocities();
    for (int cell = 0; cell < model.cells(); ++cell) fastest = std::max(fastest, length(velocities[cell]));
    return fastest;
}

/// Muscles off until all nodes have been slow for settle_window steps in a row (§2.5).
Outcome settle(const SettlingParameters &p, const SoftBodyModel &model, Engine &engine, int &steps) {
    int calm = 0;
    for (steps = 0; steps < p.settle_limit && calm < p.settle_window; ++steps) {
        const Motion motion = engine.step(p.settle_damping);
        if (motion.exploded) return Outcome::exploded;
        const double fastest = model.object_nodes == 0 ? motion.fastest : fastest_cell(model, engine);
        calm = fastest < p.settle_speed ? calm + 1 : 0;
    }
    return calm < p.settle_window ? Outcome::never_settled : Outcome::viable;
}

/// The centre of mass of the animat's nodes.
Vec2d centre_of_cells(const SoftBodyModel &model, const Engine &engine) {
    const std::vector<Vec2d> positions = engine.positions();
    return centre_of_mass(std::span(positions).first(positions.size() - model.object_nodes));
}

/// Nothing if there is no object.
std::optional<Vec2d> centre_of_object(const SoftBodyModel &model, const Engine &engine) {
    if (model.object_nodes == 0) return std::nullopt;
    const std::vector<Vec2d> positions = engine.positions();
    return centre_of_mass(std::span(positions).last(model.object_nodes));
}

/// The cells' muscles at knots, handed to the engine one knot ahead.
class Muscles {
  public:
    Muscles(const GaitParameters &parameters, double range, const SoftBodyModel &model, Gait &gait,
            const Engine &engine)
        : parameters_(parameters), range_(range), gait_(gait), from_(model.cells()), to_(model.cells()),
          now_(model.cells()), extensions_(model.nodes()), changes_(model.cells()) {
        read(0, engine);
    }

    /// On the way to the knot at t, for which the gait senses where the cells are now.
    void reach(int t, int steps, Engine &engine) {
        from_.swap(to_);
        read(t, engine);
        const double share = ramp(t, parameters_.ramp_steps);
        for (std::size_t i = 0; i < to_.size(); ++i) {
            extensions_[i] = extension(range_, share, to_[i]);
            changes_[i] += std::abs(to_[i] - from_[i]);
        }
        engine.actuate(extensions_, steps);
    }
    /// Of all cells, at the coming knot; at a knot those that the muscles have reached.
    std::span<const double> extensions() const { return extensions_; }
    /// The largest change of a rest length from the coming knot on.
    void set_range(double range) { range_ = range; }
    /// The body was moved by so much, which its cells do not sense.
    void moved(Vec2d by) { unsensed_ += by; }
    /// The body keeps only these cells.
    void keep(std::span<const int> cells, std::span<const Link> links) {
        const double before = change();
        for (std::vector<double> *list : {&from_, &to_, &now_, &extensions_, &changes_})
            keep_only(cells, *list);
        lost_change_ += before - change();
        gait_.keep(cells, links);
    }
    /// By how much all signals have changed from knot to knot so far.
    double change() const { return std::accumulate(changes_.begin(), changes_.end(), lost_change_); }
    /// The signals at this share of the way.
    std::span<const double> signals(double share) {
        for (std::size_t i = 0; i < now_.size(); ++i) now_[i] = from_[i] + share * (to_[i] - from_[i]);
        return now_;
    }

  private:
    void read(int t, const Engine &engine) {
        if (gait_.senses()) {
            std::vector<Vec2d> places = engine.positions();
            places.resize(to_.size()); // without the object
            for (Vec2d &place : places) place -= unsensed_;
            gait_.sense(places);
        }
        gait_.signals(t, to_);
    }

    const GaitParameters &parameters_;
    double range_;
    Gait &gait_;
    std::vector<double> from_, to_, now_, extensions_, changes_; // per cell; extensions also of the object, 0
    double lost_change_ = 0;                                     // of cells that are lost
    Vec2d unsensed_;
};

bool has_same_ground(const Environment &a, const Environment &b) {
    return a.has_ground == b.has_ground && a.ground == b.ground;
}

/// The body, the world that it is in, and where it counts as being.
class Way {
  public:
    Way(const SoftBodyModel &model, const Environment &environment, const Parameters &parameters,
        const Course &course, Engine &engine, TrialObserver *observer, Trial &trial)
        : model_(&model), environment_(&environment), parameters_(parameters), course_(course),
          engine_(engine), observer_(observer), trial_(trial) {
        engine_.load(model, environment);
    }

    /// Rest, if it begins with that; false if the body does not come to rest.
    bool begin() {
        if (!fits(model_->positions)) return false;
        if (environment_->gravity > 0 && !settles(trial_.settle_steps)) return false;
        trial_.rest = centre();
        trial_.object_rest = centre_of_object(*model_, engine_);
        trial_.path.push_back(trial_.rest);
        if (!course_.phases.empty()) trial_.phases.push_back({0, trial_.settle_steps, trial_.rest, {}});
        return true;
    }
    /// What happens before step t; false if the body does not come to rest again.
    bool pass(int t, Muscles &muscles) {
        const auto is_due = [&](int at) { return t == at * course_.refinement; };
        if (course_.loss && is_due(course_.loss->at)) lose(*course_.loss, muscles);
        for (const Phase &phase : course_.phases)
            if (is_due(phase.at) && !enter(phase, t, muscles)) return false;
        return true;
    }
    /// Before the step that follows step t.
    void set_flow(int t) {
        if (environment_->current.changes())
            engine_.set_flow(
                environment_->current.at(static_cast<double>(t - entered_) / course_.refinement));
    }
    /// The centre of mass, without its jumps.
    Vec2d centre() const { return centre_of_cells(*model_, engine_) - jumps_; }
    void finish(int t) {
        trial_.finish = centre();
        trial_.object_finish = centre_of_object(*model_, engine_);
        leave(t);
    }

  private:
    /// Whether there is room for the body here.
    bool fits(std::span<const Vec2d> positions) {
        if (has_room(*model_, positions, *environment_)) return true;
        trial_.outcome = Outcome::never_settled;
        return false;
    }
    bool settles(int &steps) {
        trial_.outcome = settle(parameters_.settling, *model_, engine_, steps);
        return trial_.outcome == Outcome::viable;
    }
    void leave(int t) {
        if (trial_.phases.empty()) return;
        trial_.phases.back().steps = t - entered_;
        trial_.phases.back().finish = centre();
    }
    bool enter(const Phase &phase, int t, Muscles &muscles) {
        leave(t);
        BodyState state{engine_.positions(), engine_.velocities()};
        const bool has_walls = phase.environment.has_walls();
        if (phase.environment.has_ground &&
            (has_walls || !has_same_ground(phase.environment, *environment_))) {
            const double above = has_walls ? clearance_of_walls : 0;
            const Vec2d up{0, above - height_of_lowest(state.positions, 0, phase.environment)};
            for (Vec2d &position : state.positions) position += up;
            muscles.moved(up);
        }
        environment_ = &phase.environment, entered_ = t;
        if (!fits(state.positions)) return false;
        muscles.set_range(phase.actuation_range);
        load(state, muscles);
        PhaseResult &result = trial_.phases.emplace_back();
        if (phase.settles) {
            if (!settles(result.settle_steps)) return false;
            tell(muscles);
        }
        result.start = centre();
        return true;
    }
    void lose(const Loss &loss, Muscles &muscles) {
        BodyState state{engine_.positions(), engine_.velocities()};
        keep_only(loss.kept, state.positions), keep_only(loss.kept, state.velocities);
        muscles.keep(loss.kept, loss.model.links);
        model_ = &loss.model;
        load(state, muscles);
    }
    /// Goes on in this state, the centre of mass where it was.
    void load(const BodyState &state, const Muscles &muscles) {
        jumps_ += centre_of_mass(state.positions) - centre_of_mass(engine_.positions());
        engine_.load(*model_, *environment_, state);
        engine_.actuate(muscles.extensions(), 1);
        tell(muscles);
    }
    void tell(const Muscles &muscles) {
        if (!observer_) return;
        observer_->change(*model_, *environment_, engine_);
        observer_->actuate(muscles.extensions(), 1);
    }

    const SoftBodyModel *model_;
    const Environment *environment_;
    const Parameters &parameters_;
    const Course &course_;
    Engine &engine_;
    TrialObserver *observer_;
    Trial &trial_;
    int entered_ = 0; // the step that the present world began with
    Vec2d jumps_;     // of the centre of mass
};

} // namespace

Trial locomote(const SoftBodyModel &model, const Environment &environment, double actuation_range,
               const Parameters &parameters, Gait &gait, Engine &engine, const MoveWatch &watch,
               TrialObserver *observer, const Course &course) {
    const GaitParameters &p = parameters.gait;
    Trial trial;
    Way way(model, environment, parameters, course, engine, observer, trial);
    if (!way.begin()) return trial;

    // Step n uses the rest lengths of t = n + 1: exact at knots, linear between them. At t = 0 the ramp is 0.
    Muscles muscles(p, actuation_range, model, gait, engine);
    const int late = last_quarter(p.locomotion_steps, p.knot_interval);
    double before = 0; // change of signals before it
    if (watch) watch(0, engine.positions(), muscles.signals(1));
    if (observer) observer->begin(model, environment, engine, muscles.signals(1));
    for (int start = 0; start < p.locomotion_steps; start += p.knot_interval) {
        if (start == late) before = muscles.change();
        if (!way.pass(start, muscles)) return trial;
        muscles.reach(start + p.knot_interval, p.knot_interval, engine);
        if (observer) observer->actuate(muscles.extensions(), p.knot_interval);
        for (int j = 1; j <= p.knot_interval; ++j) {
            const int t = start + j;
            way.set_flow(t - 1);
            const Motion motion = engine.step(0);
            if (motion.exploded || !gait.is_sound()) {
                trial.outcome = Outcome::exploded;
                return trial;
            }
            if (t % p.path_interval == 0) trial.path.push_back(way.centre());
            const double share = static_cast<double>(j) / p.knot_interval;
            if (watch) watch(t, engine.positions(), muscles.signals(share));
            if (observer) observer->step(t, engine, muscles.signals(share));
        }
    }
    way.finish(p.locomotion_steps);
    trial.activity = gait.activity();
    const double change = muscles.change();
    trial.late_actuation = change > 0 ? (change - before) / change : 0;
    return trial;
}

} // namespace planula
