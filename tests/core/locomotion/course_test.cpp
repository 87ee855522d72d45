// SPDX-License-Identifier: MIT
// Bodies that come into other worlds and lose cells while they move (decision 0025).
#include "locomotion/course.h"

#include "base/math.h"
#include "body/damage.h"
#include "locomotion/trial.h"
#include "physics/embody.h"
#include "support/motion.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace planula;
using namespace planula::specimens;

namespace {

/// A wave along the cells; senses where they are.
struct Wave : Gait {
    void signals(int t, std::span<double> signal) override {
        for (std::size_t i = 0; i < cells.size(); ++i) signal[i] = math::sin(0.05 * t + 0.7 * cells[i]);
        asked.push_back(t);
    }
    bool senses() const override { return true; }
    void sense(std::span<const Vec2d> places) override { sensed.push_back(centre_of_mass(places)); }
    void keep(std::span<const int> kept, std::span<const Link>) override {
        cells.assign(kept.begin(), kept.end());
    }
    explicit Wave(int count) {
        for (int i = 0; i < count; ++i) cells.push_back(i);
    }
    std::vector<int> cells, asked;
    std::vector<Vec2d> sensed;
};

Parameters brief(int steps = 200) {
    Parameters p;
    p.gait.locomotion_steps = steps, p.gait.ramp_steps = 50, p.gait.path_interval = 10;
    return p;
}

Trial moved(const Body &body, const Environment &environment, const Course &course,
            const MoveWatch &watch = {}, std::string_view engine = "reference", Gait *gait = nullptr,
            const Parameters &p = brief()) {
    const SoftBodyModel model = soft_body(body, environment);
    Wave wave(body.cells());
    return locomote(model, environment, 0.4, p, gait ? *gait : wave, *make_engine(engine), watch, nullptr,
                    course);
}

double farthest(const std::vector<Vec2d> &a, const std::vector<Vec2d> &b) {
    BOOST_TEST_REQUIRE(a.size() == b.size());
    return farthest_apart(a, b);
}

Loss loss_of(const Body &body, const Environment &environment, const Damage &damage) {
    const auto kept = cells_left(body, damage);
    return {damage.at, kept, soft_body(part_of(body, kept), environment)};
}

} // namespace

BOOST_AUTO_TEST_CASE(a_phase_in_the_same_world_changes_nothing_but_what_is_told) {
    for (const Environment &environment : {water(), land()})
        for (const std::string_view engine : engine_names()) {
            const Trial plain = moved(lattice(6, 3), environment, {}, {}, engine);
            const std::vector<Phase> phases{{50, environment, 0.4, false}, {120, environment, 0.4, false}};
            const Trial divided = moved(lattice(6, 3), environment, {.phases = phases}, {}, engine);
            BOOST_TEST(farthest(plain.path, divided.path) < (engine == "native" ? 1e-3 : 1e-6), engine);
            BOOST_TEST(plain.phases.empty());
            BOOST_TEST_REQUIRE(divided.phases.size() == 3u);
            BOOST_TEST(divided.phases[0].start == divided.rest);
            BOOST_TEST(divided.phases[0].settle_steps == divided.settle_steps);
            const int steps[] = {50, 70, 80};
            for (int i = 0; i < 3; ++i) {
                BOOST_TEST(divided.phases[i].steps == steps[i]);
                if (i > 0) BOOST_TEST(length(divided.phases[i].start - divided.phases[i - 1].finish) < 1e-9);
            }
            BOOST_TEST(divided.phases[0].finish == divided.path[5]);
            BOOST_TEST(divided.phases[2].finish == divided.finish);
        }
}

BOOST_AUTO_TEST_CASE(a_body_that_comes_from_water_onto_land_is_set_on_the_ground_and_can_settle) {
    for (const bool settles : {false, true})
        for (const std::string_view engine : engine_names()) {
            const std::vector<Phase> phases{{100, land(), 0.3, settles}};
            double lowest_in_water = 0, lowest_on_land = 0;
            Vec2d sensed_before, sensed_after;
            Wave gait(18);
            const Trial trial = moved(
                lattice(6, 3), water(), {.phases = phases},
                [&](int step, std::span<const Vec2d> nodes, auto) {
                    const double lowest = height_of_lowest(nodes, 0, land());
                    (step <= 100 ? lowest_in_water : lowest_on_land) = step == 100 || step == 101 ? lowest
                                                                       : step < 100 ? lowest_in_water
                                                                                    : lowest_on_land;
                },
                engine, &gait);
            BOOST_TEST_REQUIRE(trial.outcome == Outcome::viable, engine);
            BOOST_TEST(lowest_in_water < -0.5, engine);
            BOOST_TEST(std::abs(lowest_on_land) < 0.1, engine << ": " << lowest_on_land);
            BOOST_TEST((trial.phases[1].settle_steps > 0) == settles, engine);
            BOOST_TEST(trial.settle_steps == 0);
            // The way goes on where it was, and cells do not sense that they were moved.
            for (std::size_t i = 1; i < trial.path.size(); ++i)
                BOOST_TEST(length(trial.path[i] - trial.path[i - 1]) < (settles ? 1.5 : 0.5),
                           engine << " " << i);
            for (std::size_t i = 1; i < gait.sensed.size(); ++i)
                BOOST_TEST(length(gait.sensed[i] - gait.sensed[i - 1]) < (settles ? 1.5 : 0.5),
                           engine << " " << i);
        }
}

BOOST_AUTO_TEST_CASE(a_body_that_never_settles_in_a_phase_ends_its_trial) {
    Parameters p = brief();
    p.settling.settle_limit = p.settling.settle_window; // which it needs from rest
    const std::vector<Phase> phases{{100, land(), 0.3, true}};
    const Trial trial = moved(lattice(6, 3), water(), {.phases = phases}, {}, "native", nullptr, p);
    BOOST_TEST((trial.outcome == Outcome::never_settled));
}

BOOST_AUTO_TEST_CASE(a_phase_has_its_own_fluid_ground_and_range) {
    // From still water into a current that carries, and into one that changes from the beginning of its phase on.
    Environment current = water(), changing = water();
    current.flow = {2, 0};
    changing.current = {{{0, 0}, {0, 3}}, 50, false};
    const std::vector<Phase> phases{{100, current, 0, false}, {300, changing, 0, false}};
    const Trial trial = moved(lattice(6, 3), water(), {.phases = phases}, {}, "native", nullptr, brief(600));
    BOOST_TEST_REQUIRE(trial.phases.size() == 3u);
    const auto way = [&](int i) { return trial.phases[i].finish - trial.phases[i].start; };
    BOOST_TEST(std::abs(way(0).x) < 0.3);
    BOOST_TEST(way(1).x > 0.5);
    BOOST_TEST(way(2).y > 0.5);
}

BOOST_AUTO_TEST_CASE(a_current_is_that_of_the_step_and_the_first_one_while_the_body_settles) {
    struct Flows : Engine {
        using Engine::load;
        void load(const SoftBodyModel &, const Environment &, const BodyState &) override {}
        void set_flow(Vec2d flow) override { flows.push_back(flow.x); }
        void actuate(std::span<const double>, int) override {}
        Motion step(double) override {
            ++steps;
            return {};
        }
        std::vector<Vec2d> positions() const override { return {{}, {}}; }
        std::vector<Vec2d> velocities() const override { return {{}, {}}; }
        std::vector<double> flows;
        int steps = 0;
    } engine;
    Environment environment = land();
    environment.current = {{{0, 0}, {10, 0}}, 10, true};
    Wave gait(2);
    Parameters p = brief(40);
    locomote(soft_body(lattice(2, 1), environment), environment, 0.4, p, gait, engine, {}, nullptr,
             {.refinement = 2});
    BOOST_TEST(engine.steps == p.settling.settle_window + 40);
    BOOST_TEST_REQUIRE(engine.flows.size() == 40u);
    for (int t = 0; t < 40; ++t)
        BOOST_TEST(std::abs(engine.flows[t] - (t <= 20 ? t / 2.0 : 20 - t / 2.0)) < 1e-12);
}

BOOST_AUTO_TEST_CASE(lost_cells_are_gone_and_the_others_go_on) {
    for (const Environment &environment : {water(), land()})
        for (const std::string_view engine : engine_names()) {
            const Body body = lattice(8, 3);
            const Loss loss = loss_of(body, environment, {.at = 100, .share = 0.4, .side = Side::left});
            std::vector<Vec2d> before, after;
            std::size_t nodes_at_end = 0, signals_at_end = 0;
            const Trial trial = moved(
                body, environment, {.loss = &loss},
                [&](int step, std::span<const Vec2d> nodes, std::span<const double> signals) {
                    if (step == 100) before.assign(nodes.begin(), nodes.end());
                    if (step == 101) after.assign(nodes.begin(), nodes.end());
                    nodes_at_end = nodes.size(), signals_at_end = signals.size();
                },
                engine);
            BOOST_TEST_REQUIRE(trial.outcome == Outcome::viable, engine);
            BOOST_TEST(nodes_at_end == loss.kept.size());
            BOOST_TEST(signals_at_end == loss.kept.size());
            for (std::size_t i = 0; i < loss.kept.size(); ++i)
                BOOST_TEST(length(after[i] - before[loss.kept[i]]) < 0.2, engine);
            for (std::size_t i = 1; i < trial.path.size(); ++i)
                BOOST_TEST(length(trial.path[i] - trial.path[i - 1]) < 1, engine);
            // A quarter of the time with 0.6 of the cells, of half with all and half with 0.6.
            BOOST_TEST(std::abs(trial.late_actuation - 0.15 / 0.8) < 0.01);
        }
}

BOOST_AUTO_TEST_CASE(no_lost_cell_changes_nothing) {
    for (const std::string_view engine : engine_names()) {
        const Loss loss = loss_of(lattice(6, 3), water(), {.at = 100});
        const Trial plain = moved(lattice(6, 3), water(), {}, {}, engine);
        const Trial same = moved(lattice(6, 3), water(), {.loss = &loss}, {}, engine);
        BOOST_TEST(farthest(plain.path, same.path) < (engine == "native" ? 1e-3 : 1e-6), engine);
        BOOST_TEST(same.late_actuation == plain.late_actuation);
    }
}

BOOST_AUTO_TEST_CASE(the_engines_agree_on_phases_and_losses) {
    const Body body = lattice(8, 3);
    const Loss loss = loss_of(body, water(), {.at = 50, .share = 0.3, .side = Side::right});
    const std::vector<Phase> phases{{100, land(), 0.3, false}};
    const Trial reference = moved(body, water(), {.phases = phases, .loss = &loss}, {}, "reference");
    for (const std::string_view engine : {"native", "bullet"}) {
        const Trial other = moved(body, water(), {.phases = phases, .loss = &loss}, {}, engine);
        const double apart = length(other.finish - reference.finish);
        BOOST_TEST(apart < (engine == "native" ? 0.01 : 0.2), engine << ": " << apart);
    }
}
