// SPDX-License-Identifier: MIT
// What a life tells, against values by hand and laws of mechanics (decision 0026).
#include "evaluation/life_observer.h"

#include "base/math.h"
#include "evaluation/live.h"
#include "physics/energy.h"
#include "physics/engine.h"
#include "physics/reference/forces.h"
#include "support/motion.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>

using namespace planula;
using namespace planula::specimens;

namespace {

/// All observations.
ObservationSet everything() {
    ObservationSet all;
    for (std::size_t i = 0; i < observation_rows().size(); ++i) all.add(static_cast<Observation>(i));
    return all;
}

Parameters brief(int steps) {
    Parameters p;
    p.gait.locomotion_steps = steps;
    return p;
}

/// Each cell's signal as a function of time.
struct Signals : Gait {
    void keep(std::span<const int>, std::span<const Link>) override {}
    explicit Signals(std::function<double(int, std::size_t)> signal_of) : value(std::move(signal_of)) {}
    void signals(int t, std::span<double> signal) override {
        for (std::size_t cell = 0; cell < signal.size(); ++cell) signal[cell] = value(t, cell);
    }
    std::function<double(int, std::size_t)> value;
};

double wave(int t, std::size_t cell) {
    return math::sin(2 * math::pi * (t / 160.0 - static_cast<double>(cell) / 12));
}

/// What is observed while a body moves.
Observations observed(const SoftBodyModel &model, const Environment &environment, double range,
                      const Parameters &p, std::string_view engine_name,
                      const std::function<double(int, std::size_t)> &signal) {
    Signals gait(signal);
    const auto engine = make_engine(engine_name);
    LifeObserver observer(everything(), p);
    const Trial trial = locomote(model, environment, range, p, gait, *engine, {}, &observer);
    BOOST_TEST(trial.outcome == Outcome::viable);
    Observations result;
    observer.finish(result);
    return result;
}

/// An engine whose nodes stay where they are.
struct StillEngine : Engine {
    using Engine::load;
    void load(const SoftBodyModel &, const Environment &, const BodyState &state) override {
        places = state.positions;
    }
    void set_flow(Vec2d) override {}
    void actuate(std::span<const double>, int) override {}
    Motion step(double) override { return {}; }
    std::vector<Vec2d> positions() const override { return places; }
    std::vector<Vec2d> velocities() const override { return std::vector<Vec2d>(places.size()); }
    std::vector<Vec2d> places;
};

/// Beside the engine's steps: what water and the damping of springs take (as in mechanics_test.cpp).
struct Heat : TrialObserver {
    void change(const SoftBodyModel &, const Environment &, const Engine &) override {}
    void begin(const SoftBodyModel &body, const Environment &world, const Engine &engine,
               std::span<const double>) override {
        model = &body, environment = &world;
        lengths = reference::RestLengths(body);
        nodes = {engine.positions(), engine.velocities()};
    }
    void actuate(std::span<const double> extensions, int steps) override {
        lengths.actuate(extensions, steps);
    }
    void step(int, const Engine &engine, std::span<const double>) override {
        lengths.advance();
        std::vector<Vec2d> moving(nodes.positions.size()), resting(moving.size());
        reference::add_drag(*model, *environment, nodes, moving);
        reference::add_springs(*model, lengths.now(), nodes, moving);
        reference::add_springs(*model, lengths.now(), {nodes.positions, std::vector<Vec2d>(moving.size())},
                               resting);
        for (std::size_t i = 0; i < moving.size(); ++i)
            taken += dot(resting[i] - moving[i], nodes.velocities[i]) * model->time_step;
        nodes = {engine.positions(), engine.velocities()};
        stored = elastic_energy(*model, lengths.now(), nodes.positions) + kinetic_energy(nodes.velocities);
    }
    const SoftBodyModel *model = nullptr;
    const Environment *environment = nullptr;
    reference::RestLengths lengths;
    reference::Nodes nodes;
    double taken = 0, stored = 0;
};

} // namespace

BOOST_AUTO_TEST_CASE(the_work_on_one_spring_is_what_its_potential_gains) {
    // A spring of length 1 that cannot move is shortened to 0.8, lengthened to 1.2, and let go: 1/2 k 0.2² is gained
    // twice, and lost twice on the way back to its length.
    Parameters p = brief(400);
    p.gait.ramp_steps = 1;
    const auto model = soft_body(lattice(2, 1), water(), p);
    const auto signal = [](int t, std::size_t) {
        return t < 100 ? 0.0 : t < 200 ? -1.0 : t < 300 ? 1.0 : 0.0;
    };
    Signals gait(signal);
    StillEngine engine;
    LifeObserver observer(everything(), p);
    locomote(model, water(), 0.2, p, gait, engine, {}, &observer);
    Observations seen;
    observer.finish(seen);
    const double gain = 0.5 * p.body.spring_stiffness * 0.2 * 0.2;
    const auto near = boost::test_tools::tolerance(1e-9);
    BOOST_TEST(seen.work == 2 * gain, near);
    BOOST_TEST(std::abs(seen.net_work) < 1e-9 * gain);
    // Both lengths are held for 91 of 400 steps, and the ways between them store a little.
    BOOST_TEST(seen.elastic_energy > 0.45 * gain);
    BOOST_TEST(seen.elastic_energy < 0.5 * gain);
}

BOOST_AUTO_TEST_CASE(a_muscle_that_shortens_a_stretched_spring_does_positive_work) {
    BOOST_TEST(muscle_work(10, 1.5, 1, 0.9) > 0);
    BOOST_TEST(muscle_work(10, 0.5, 1, 0.9) < 0);
    BOOST_TEST(muscle_work(10, 0.5, 1, 1.1) > 0);
    BOOST_TEST(muscle_work(10, 1.5, 1, 0.9) == 5 * (0.6 * 0.6 - 0.5 * 0.5),
               boost::test_tools::tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(work_is_what_a_body_in_water_has_at_the_end_and_what_was_taken_from_it) {
    // The time step of a sixteenth: the rest is an error of integration, which shrinks with the step.
    Parameters p = refined(brief(300), 16);
    for (const char *name : {"native", "reference", "bullet"}) {
        const auto model = soft_body(lattice(6, 2), water(), p);
        const auto signal = [](int t, std::size_t cell) { return wave(t / 16, cell); };
        const Observations seen = observed(model, water(), 0.4, p, name, signal);
        Signals gait(signal);
        const auto engine = make_engine(name);
        Heat heat;
        locomote(model, water(), 0.4, p, gait, *engine, {}, &heat);
        BOOST_TEST(seen.net_work > 0);
        BOOST_TEST(heat.taken > 0.5 * seen.net_work, name);
        BOOST_TEST(std::abs(seen.net_work - heat.taken - heat.stored) < 0.02 * seen.net_work, name);
        BOOST_TEST(seen.work > seen.net_work);
    }
}

BOOST_AUTO_TEST_CASE(every_engine_tells_the_same_of_a_body) {
    const Parameters p = brief(400);
    for (const Environment &environment : {water(), land()}) {
        const auto model = soft_body(lattice(6, 2), environment, p);
        const auto seen = [&](const char *name) { return observed(model, environment, 0.3, p, name, wave); };
        const Observations reference = seen("reference");
        for (const char *name : {"native", "bullet"}) {
            const Observations other = seen(name);
            BOOST_TEST(other.work == reference.work, boost::test_tools::tolerance(0.1));
            BOOST_TEST(other.elastic_energy == reference.elastic_energy, boost::test_tools::tolerance(0.1));
            BOOST_TEST(std::abs(other.contact_time - reference.contact_time) < 0.1, name);
            BOOST_TEST(std::abs(other.contact_share - reference.contact_share) < 0.1, name);
            BOOST_TEST((other.signals == reference.signals));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_body_at_rest_touches_the_ground_all_the_time_and_one_in_water_never) {
    const Parameters p = brief(200);
    const auto still = [](int, std::size_t) { return 0.0; };
    Environment slope = land();
    slope.ground = {{-50, -25}, {50, 25}};
    slope.friction = 2;
    for (const char *name : {"native", "reference", "bullet"})
        for (const Environment &environment : {land(), slope}) {
            const auto model = soft_body(lattice(4, 2), environment, p);
            const Observations seen = observed(model, environment, 0.3, p, name, still);
            BOOST_TEST(seen.contact_time == 1, name);
            BOOST_TEST(seen.work == 0);
            if (environment.ground.empty()) BOOST_TEST(seen.contact_share == 0.5, name); // one row of two
        }
    const auto model = soft_body(lattice(4, 2), water(), p);
    BOOST_TEST(observed(model, water(), 0.3, p, "native", wave).contact_time == 0);
    // A body that a current holds at an obstacle.
    Environment stream = water();
    stream.flow = {2, 0};
    double right = 0, left = 0;
    for (const Vec2d at : model.positions) right = std::max(right, at.x), left = std::min(left, at.y);
    stream.obstacles.push_back(
        {{{right + 0.2, left - 5}, {right + 3, left - 5}, {right + 3, left + 9}, {right + 0.2, left + 9}},
         {}});
    BOOST_TEST(observed(soft_body(lattice(4, 2), stream, p), stream, 0.3, p, "native", still).contact_time >
               0.5);
}

BOOST_AUTO_TEST_CASE(signals_are_told_at_the_interval_of_the_path_and_shapes_at_the_end) {
    Parameters p = brief(400);
    p.gait.path_interval = 50;
    const auto model = soft_body(lattice(4, 2), water(), p);
    const Observations seen = observed(model, water(), 0.3, p, "native", wave);
    BOOST_TEST(seen.signals.size() == 9u);
    for (std::size_t i = 0; i < seen.signals.size(); ++i)
        for (std::size_t cell = 0; cell < 8; ++cell)
            BOOST_TEST(std::abs(seen.signals[i][cell] - wave(static_cast<int>(50 * i), cell)) < 1e-12);
    BOOST_TEST(seen.final_shape.size() == 8u);
}

BOOST_AUTO_TEST_CASE(the_period_of_oscillators_is_told_in_steps) {
    const Parameters p = brief(2000);
    const auto model = soft_body(lattice(3, 2), water(), p);
    const Observations seen = observed(model, water(), 0.3, p, "native", wave);
    BOOST_TEST(seen.period == 160, boost::test_tools::tolerance(0.005));
    for (std::size_t cell = 0; cell < 6; ++cell)
        BOOST_TEST(std::abs(seen.gait_phases[cell] + static_cast<double>(cell) / 12) < 0.01);
}

BOOST_AUTO_TEST_CASE(a_life_tells_what_it_is_asked_for_and_nothing_else_changes) {
    for (const Actuation actuation : {Actuation::oscillator, Actuation::grn}) {
        Conditions asked;
        asked.actuation = actuation;
        asked.environment = land();
        asked.actuation_range = 0.2;
        asked.parameters.gait.locomotion_steps = 400;
        const Genome lump = lump_genome(actuation, 6);
        const Life bare = live(lump, asked);
        BOOST_TEST((bare.observations == Observations{}));
        asked.observed.add(Observation::work);
        asked.observed.add(Observation::body);
        Life told = live(lump, asked);
        BOOST_TEST(told.observations.work > 0);
        BOOST_TEST(told.observations.body.size() == static_cast<std::size_t>(told.cells));
        BOOST_TEST(told.observations.net_work == 0);
        BOOST_TEST(told.observations.final_shape.empty());
        BOOST_TEST(develop(lump, asked).observations.body.size() == static_cast<std::size_t>(told.cells));
        told.observations = {};
        BOOST_TEST((told == bare));
    }
}
