// SPDX-License-Identifier: MIT
#include "locomotion/oscillator.h"

#include "base/math.h"
#include "network/network.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace planula;

BOOST_AUTO_TEST_CASE(outputs_span_the_range_of_periods_and_phases) {
    const Network network = express(specimens::bare_genome(Actuation::oscillator), 16);
    Tissue tissue{Activations(network.nodes, 3), {0, 0, 0}};
    for (int cell = 0; cell < 3; ++cell)
        for (const output::Channel channel : {output::period, output::phase})
            tissue.activations.at(cell, input::count + channel) = cell - 1;
    const auto oscillators = read_oscillators(network, tissue, GaitParameters{});
    BOOST_TEST(oscillators[0].period == 100);
    BOOST_TEST(oscillators[1].period == 250);
    BOOST_TEST(oscillators[2].period == 400);
    BOOST_TEST(oscillators[0].phase == -math::pi);
    BOOST_TEST(oscillators[2].phase == math::pi);
}

BOOST_AUTO_TEST_CASE(the_turned_phase_is_the_sine_of_eq_1_to_the_end) {
    const std::vector<Oscillator> cells{{100, 0}, {137.3, 2.5}, {400, -math::pi}};
    const Parameters p;
    Oscillators gait(cells, p.gait);
    std::vector<double> signal(cells.size());
    for (int t = 0; t <= p.gait.locomotion_steps; t += p.gait.knot_interval) {
        gait.signals(t, signal);
        for (std::size_t i = 0; i < cells.size(); ++i)
            BOOST_REQUIRE(
                std::abs(signal[i] - std::sin(2 * math::pi * t / cells[i].period + cells[i].phase)) < 1e-12);
    }
    BOOST_TEST(gait.activity() == 0);
}
