// SPDX-License-Identifier: MIT
#include "locomotion/grn.h"

#include "cell/senses.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace planula;
using namespace planula::specimens;

namespace {

/// Two linked cells whose spring output follows its own old value: s ← tanh(w s), from these starts.
struct Pair {
    explicit Pair(double weight, double first, double second) {
        Genome genome = bare_genome(Actuation::grn);
        const int spring = genome.inputs + output::spring;
        add_link(genome, spring, spring, weight);
        wire(genome, input::morphogen, output::morphogen, 1);
        network = express(genome, 16);
        tissue.activations = Activations(network.nodes, 2);
        tissue.activations.at(0, spring) = first, tissue.activations.at(1, spring) = second;
        tissue.morphogens = {0.5, -0.25};
    }
    Network network;
    Body body = make_body({{0, 0}, {1, 0}}, 1.5);
    Tissue tissue;
    Parameters parameters;
};

const auto near = boost::test_tools::tolerance(1e-14);

} // namespace

BOOST_AUTO_TEST_CASE(signals_move_linearly_one_interval_behind_the_updates) {
    const Pair pair(-3, 0.5, 0);
    GrnMuscles gait(pair.network, pair.body, pair.tissue, pair.parameters);
    const double s1 = std::tanh(-1.5), s2 = std::tanh(-3 * s1);
    std::vector<double> signal(2);
    for (int t = 0; t <= 100; t += 10) {
        gait.signals(t, signal);
        // Eq. (2); the first previous output is 0, whatever development left.
        const double expected = t < 50 ? t / 50.0 * s1 : s1 + (t - 50) / 50.0 * (s2 - s1);
        BOOST_TEST(signal[0] == (t == 100 ? s2 : expected), near);
        BOOST_TEST(signal[1] == 0);
    }
}

BOOST_AUTO_TEST_CASE(there_are_eighty_updates_and_the_last_is_reached_at_the_end) {
    const Pair pair(-3, 0.5, 0);
    GrnMuscles gait(pair.network, pair.body, pair.tissue, pair.parameters);
    double s = 0.5, sum = 0;
    std::vector<double> signal(2);
    for (int t = 0; t <= 4000; t += 10) gait.signals(t, signal);
    for (int u = 1; u <= 80; ++u) {
        const double next = std::tanh(-3 * s);
        if (u > 1) sum += std::abs(next - s);
        s = next;
    }
    BOOST_TEST(signal[0] == s, near);
    BOOST_TEST(gait.activity() == sum / (2 * 2 * 79), boost::test_tools::tolerance(1e-12)); // Eq. (5)
}

BOOST_AUTO_TEST_CASE(the_activity_of_cells_that_flip_from_end_to_end_is_one) {
    // Weight −100 drives the output to ±1 at every update, in both cells.
    const Pair pair(-100, 1, 1);
    GrnMuscles gait(pair.network, pair.body, pair.tissue, pair.parameters);
    std::vector<double> signal(2);
    for (int t = 0; t <= 4000; t += 10) gait.signals(t, signal);
    BOOST_TEST(gait.activity() == 1, near);
}

BOOST_AUTO_TEST_CASE(the_first_morphogen_is_averaged_from_the_last_decision_over_the_final_mesh) {
    // The spring output reads the morphogen input: cell 0 first reads −0.25 from cell 1, then tanh of the
    // value that cell 1 has made of it.
    Genome genome = bare_genome(Actuation::grn);
    wire(genome, input::morphogen, output::spring, 1);
    wire(genome, input::morphogen, output::morphogen, 1);
    const Network network = express(genome, 16);
    Pair pair(0, 0, 0);
    GrnMuscles gait(network, pair.body, pair.tissue, pair.parameters);
    std::vector<double> signal(2);
    for (int t = 0; t <= 50; t += 10) gait.signals(t, signal);
    BOOST_TEST(signal[0] == std::tanh(-0.25), near);
    BOOST_TEST(signal[1] == std::tanh(0.5), near);
    for (int t = 60; t <= 100; t += 10) gait.signals(t, signal);
    BOOST_TEST(signal[0] == std::tanh(std::tanh(0.5)), near);
}

BOOST_AUTO_TEST_CASE(an_activation_that_is_not_finite_is_reported) {
    Pair pair(-3, 0.5, 0);
    pair.tissue.activations.at(1, input::count + output::spring) = std::numeric_limits<double>::quiet_NaN();
    GrnMuscles gait(pair.network, pair.body, pair.tissue, pair.parameters);
    std::vector<double> signal(2);
    BOOST_TEST(gait.is_sound());
    gait.signals(0, signal);
    BOOST_TEST(!gait.is_sound());
}

BOOST_AUTO_TEST_CASE(networks_at_rest_are_those_that_go_on_being_updated) {
    // Random networks against plain updates of all cells, to the bit; some come to rest, some oscillate.
    int resting = 0, moving = 0;
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        const Network network = express(random_genome(Actuation::grn, seed), 16);
        const Body body = make_body({{0, 0}, {1, 0}, {0.5, 0.8}}, 1.5);
        Tissue tissue{Activations(network.nodes, 3), {0.5, -0.25, 0}};
        const Parameters parameters;
        GrnMuscles gait(network, body, tissue, parameters);

        Activations &activations = tissue.activations;
        for (int cell = 0; cell < 3; ++cell) {
            const auto inputs = sense(body.positions[cell], 0, 1, parameters.network);
            for (int node = 0; node < input::count; ++node) activations.at(cell, node) = inputs[node];
        }
        const int spring = network.inputs + output::spring, morphogen = network.inputs + output::morphogen;
        std::vector<double> signal(3);
        std::vector<double> newest(3), previous(3);
        for (int t = 0; t < parameters.gait.locomotion_steps; t += parameters.gait.knot_interval) {
            gait.signals(t, signal);
            if (t % parameters.gait.update_interval != 0) continue;
            // Here the signal is what the update before has left.
            BOOST_REQUIRE((signal == newest));
            for (int cell = 0; cell < 3; ++cell) {
                const int low = cell == 0 ? 1 : 0, high = cell == 2 ? 1 : 2;
                activations.at(cell, input::morphogen) =
                    (tissue.morphogens[low] + tissue.morphogens[high]) / 2;
            }
            step(network, activations);
            previous = newest;
            for (int cell = 0; cell < 3; ++cell) {
                tissue.morphogens[cell] = activations.at(cell, morphogen);
                newest[cell] = activations.at(cell, spring);
            }
        }
        (newest == previous ? resting : moving) += 1;
    }
    BOOST_TEST(resting >= 10);
    BOOST_TEST(moving >= 5);
}

BOOST_AUTO_TEST_CASE(time_and_place_are_updated_where_the_experiment_says_so) {
    // The spring output is the tanh of one input.
    const auto newest = [](input::Channel channel, const Parameters &parameters, Vec2d shift) {
        Genome genome = bare_genome(Actuation::grn);
        wire(genome, channel, output::spring, 1);
        const Network network = express(genome, 16);
        const Body body = make_body({{3, 1}, {4, 1}}, 1.5);
        const Tissue tissue{Activations(network.nodes, 2), {0, 0}};
        GrnMuscles gait(network, body, tissue, parameters);
        std::vector<double> signal(2);
        // The world's origin is elsewhere; from step 50 on the body lies further on by the shift.
        for (int t = 0; t <= 100; t += 10) {
            const Vec2d place = Vec2d{-7, 20} + (t < 50 ? Vec2d{} : shift);
            if (gait.senses()) gait.sense(std::vector<Vec2d>{place, place + Vec2d{1, 0}});
            gait.signals(t, signal);
        }
        return signal[0];
    };
    Parameters standard, rising, present;
    standard.gait.gait_time = GaitTime::held, standard.gait.gait_place = GaitPlace::grown;
    rising = present = standard;
    rising.gait.gait_time = GaitTime::rising;
    present.gait.gait_place = GaitPlace::present;
    BOOST_TEST(newest(input::time, standard, {2, 4}) == std::tanh(1), near);
    BOOST_TEST(newest(input::time, rising, {2, 4}) == std::tanh(1 + 50.0 / 600), near);
    BOOST_TEST(newest(input::time, present, {2, 4}) == std::tanh(1), near);
    BOOST_TEST(newest(input::x, standard, {2, 4}) == std::tanh(0.3), near);
    BOOST_TEST(newest(input::x, present, {2, 4}) == std::tanh(0.5), near);
    BOOST_TEST(newest(input::y, present, {2, 4}) == std::tanh(0.5), near);
    const double east = std::exp(-std::hypot(5.0, 5.0) / 10);
    BOOST_TEST(newest(input::maternal_east, present, {2, 4}) == std::tanh(east), near);
}
