// SPDX-License-Identifier: MIT
#include "locomotion/trial.h"

#include "base/math.h"
#include "physics/embody.h"
#include "physics/native/native_engine.h"
#include "support/print.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace planula;
using namespace planula::specimens;

namespace {

/// All cells follow one signal.
struct SameSignal : Gait {
    explicit SameSignal(std::function<double(int)> signal_of) : value(std::move(signal_of)) {}
    void signals(int t, std::span<double> signal) override {
        asked.push_back(t);
        std::fill(signal.begin(), signal.end(), value(t));
    }
    void keep(std::span<const int>, std::span<const Link>) override {}
    std::function<double(int)> value;
    std::vector<int> asked;
};

/// An engine that records the extension of its first node, and whose nodes have a given speed.
struct RecordingEngine : Engine {
    void load(const SoftBodyModel &, const Environment &, const BodyState &) override {}
    void set_flow(Vec2d flow) override { flows.push_back(flow); }
    void actuate(std::span<const double> extensions, int steps) override {
        from = to, to = extensions[0], interval = steps, since = 0;
    }
    Motion step(double damping) override {
        since = std::min(since + 1, interval);
        lengths.push_back(interval == 0 ? 1 : 1 + 2 * (from + (to - from) * since / interval));
        dampings.push_back(damping);
        return {speed(static_cast<int>(lengths.size())), false};
    }
    std::vector<Vec2d> positions() const override { return {{static_cast<double>(lengths.size()), 0}}; }
    std::vector<Vec2d> velocities() const override { return {{}}; }
    std::function<double(int)> speed = [](int) { return 0.0; };
    double from = 0, to = 0;
    int interval = 0, since = 0;
    std::vector<Vec2d> flows;
    std::vector<double> lengths, dampings; // of a spring of length 1 between equal nodes
};

/// Every cell contracts at the shortest period, in a phase of its own: neighbours pull against each other.
struct OpposedSignals : Gait {
    void signals(int t, std::span<double> signal) override {
        for (std::size_t cell = 0; cell < signal.size(); ++cell)
            signal[cell] = math::sin(math::pi * (0.02 * t + 1.37 * static_cast<double>(cell)));
    }
    void keep(std::span<const int>, std::span<const Link>) override {}
};

/// Three rows that lie close: triangles with sides of 1, 0.64 and 0.64.
Body flat_lattice() {
    std::vector<Vec2d> positions;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 6; ++column) positions.push_back({column + 0.5 * (row % 2), 0.4 * row});
    return make_body(positions, 1.5);
}

/// The smallest signed area that any triangle had, over its area in equilibrium.
double least_area(const Body &body, const Environment &environment, double range, const Parameters &p = {}) {
    const SoftBodyModel model = soft_body(body, environment, p);
    OpposedSignals gait;
    const auto engine = make_engine("native");
    double least = std::numeric_limits<double>::infinity();
    const auto look = [&](int, std::span<const Vec2d> at, std::span<const double>) {
        for (std::size_t i = 0; i < model.triangles.size(); ++i) {
            const auto [a, b, c] = model.triangles[i];
            least = std::min(least, 0.5 * cross(at[b] - at[a], at[c] - at[a]) / model.areas[i]);
        }
    };
    locomote(model, environment, range, p, gait, *engine, look);
    return least;
}

} // namespace

BOOST_AUTO_TEST_CASE(step_n_uses_the_rest_lengths_of_t_n_plus_1_linear_between_knots) {
    const auto model = soft_body(lattice(2, 1), water());
    SameSignal gait([](int t) { return std::sin(0.05 * t); });
    RecordingEngine engine;
    locomote(model, water(), 0.4, Parameters(), gait, engine);
    BOOST_TEST(engine.lengths.size() == 4000u);
    const auto knot = [](int t) { return 1 + std::min(1.0, t / 200.0) * 0.4 * std::sin(0.05 * t); };
    for (const int n : {0, 4, 9, 10, 57, 199, 200, 2345, 3999}) {
        const int t = n + 1, start = (t - 1) / 10 * 10;
        const double expected = knot(start) + (t - start) / 10.0 * (knot(start + 10) - knot(start));
        BOOST_TEST(engine.lengths[n] == expected, boost::test_tools::tolerance(1e-12));
    }
    BOOST_TEST(gait.asked.size() == 401u);
    BOOST_TEST(gait.asked.back() == 4000);
}

BOOST_AUTO_TEST_CASE(late_actuation_distinguishes_a_rhythm_from_a_single_contraction) {
    const auto model = soft_body(lattice(2, 1), water());
    const auto late = [&](const std::function<double(int)> &signal) {
        SameSignal gait(signal);
        RecordingEngine engine;
        return locomote(model, water(), 0.4, Parameters(), gait, engine).late_actuation;
    };
    BOOST_TEST(late([](int t) { return t / 10 % 2; }) == 0.25);
    BOOST_TEST(late([](int t) { return std::min(1.0, t / 80.0); }) == 0);
    BOOST_TEST(late([](int) { return 0.7; }) == 0);
    BOOST_TEST(late([](int t) { return t > 3000; }) == 1);
    BOOST_TEST(late([](int t) { return t >= 3000; }) == 0);
}

BOOST_AUTO_TEST_CASE(in_water_there_is_no_settling_and_rest_is_the_start) {
    const auto model = soft_body(lattice(2, 1), water());
    SameSignal gait([](int) { return 0.0; });
    RecordingEngine engine;
    const Trial trial = locomote(model, water(), 0.4, Parameters(), gait, engine);
    BOOST_TEST(trial.settle_steps == 0);
    BOOST_TEST((trial.rest == Vec2d{0, 0}));
    BOOST_TEST((trial.finish == Vec2d{4000, 0}));
    BOOST_TEST(trial.path.size() == 41u);
    BOOST_TEST((trial.path[1] == Vec2d{100, 0}));
    for (const double damping : engine.dampings) BOOST_REQUIRE(damping == 0);
}

BOOST_AUTO_TEST_CASE(a_body_must_be_slow_for_the_whole_window_in_a_row) {
    // Slow from step 101 on except at step 500: it is at rest at step 500 + 800.
    const auto model = soft_body(lattice(2, 1), land());
    SameSignal gait([](int) { return 0.0; });
    RecordingEngine engine;
    engine.speed = [](int step) { return step <= 100 || step == 500 ? 0.05 : 0.049; };
    const Trial trial = locomote(model, land(), 0.3, Parameters(), gait, engine);
    BOOST_TEST(trial.outcome == Outcome::viable);
    BOOST_TEST(trial.settle_steps == 1300);
    BOOST_TEST((trial.rest == Vec2d{1300, 0}));
    BOOST_TEST(engine.dampings[1299] == 1);
    BOOST_TEST(engine.dampings[1300] == 0);
    BOOST_TEST(gait.asked.front() == 0);
}

BOOST_AUTO_TEST_CASE(the_limit_of_settling_includes_the_window) {
    const auto model = soft_body(lattice(2, 1), land());
    SameSignal gait([](int) { return 0.0; });
    RecordingEngine just, late;
    just.speed = [](int step) { return step <= 5200 ? 1.0 : 0.0; };
    late.speed = [](int step) { return step <= 5201 ? 1.0 : 0.0; };
    BOOST_TEST(locomote(model, land(), 0.3, Parameters(), gait, just).outcome == Outcome::viable);
    const Trial trial = locomote(model, land(), 0.3, Parameters(), gait, late);
    BOOST_TEST(trial.outcome == Outcome::never_settled);
    BOOST_TEST(trial.settle_steps == 6000);
    BOOST_TEST(late.lengths.size() == 6000u);
}

BOOST_AUTO_TEST_CASE(constant_actuation_does_not_displace_a_body) {
    // The centre of mass moves less than 0.01 cells in the last 1000 of 4000 steps.
    for (const bool on_land : {false, true}) {
        const Environment environment = on_land ? land() : water();
        const auto model = soft_body(lattice(6, 3), environment);
        SameSignal gait([](int) { return 0.8; });
        NativeEngine engine;
        const Trial trial = locomote(model, environment, 0.3, Parameters(), gait, engine);
        BOOST_TEST(trial.outcome == Outcome::viable);
        BOOST_TEST(length(trial.path[40] - trial.path[30]) < 0.01);
    }
}

BOOST_AUTO_TEST_CASE(signals_that_make_a_body_explode_end_the_trial) {
    const auto model = soft_body(lattice(6, 3), water());
    SameSignal gait([](int t) { return t < 1000 ? 0.0 : std::numeric_limits<double>::quiet_NaN(); });
    NativeEngine engine;
    BOOST_TEST(locomote(model, water(), 0.4, Parameters(), gait, engine).outcome == Outcome::exploded);
}

BOOST_AUTO_TEST_CASE(pressure_keeps_triangles_from_turning_inside_out_under_the_widest_actuation) {
    // Round triangles, a fold, and triangles so flat that their springs alone could not keep them open.
    for (const Body &body : {lattice(8, 3), lattice(5, 5), hook(), flat_lattice()})
        for (const Environment &environment : {water(), land()}) {
            const double least = least_area(body, environment, 0.4);
            BOOST_TEST(least > 0.1);
            BOOST_TEST(least < 1);
        }

    Parameters slack;
    slack.body.pressure_stiffness = 0;
    BOOST_TEST(least_area(flat_lattice(), water(), 0.4, slack) < 0);
}
