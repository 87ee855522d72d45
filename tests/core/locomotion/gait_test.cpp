// SPDX-License-Identifier: MIT
#include "locomotion/gait.h"

#include "physics/laws/spring.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

using namespace planula;

namespace {

const auto near = boost::test_tools::tolerance(1e-14);

} // namespace

BOOST_AUTO_TEST_CASE(the_amplitude_rises_over_the_ramp) {
    const Parameters p;
    BOOST_TEST(ramp(0, p.gait.ramp_steps) == 0);
    BOOST_TEST(ramp(50, p.gait.ramp_steps) == 0.25);
    BOOST_TEST(ramp(200, p.gait.ramp_steps) == 1);
    BOOST_TEST(ramp(4000, p.gait.ramp_steps) == 1);
}

BOOST_AUTO_TEST_CASE(cells_with_equal_signals_change_a_rest_length_by_the_whole_range) {
    BOOST_TEST(actuated_length(2.0, extension(0.4, 1, 1), extension(0.4, 1, 1)) == 2.8, near);
    BOOST_TEST(actuated_length(2.0, extension(0.4, 1, -1), extension(0.4, 1, -1)) == 1.2, near);
    BOOST_TEST(actuated_length(2.0, extension(0.4, 1, 1), extension(0.4, 1, -1)) == 2);
    BOOST_TEST(actuated_length(2.0, extension(0.4, 0.5, 1), extension(0.4, 0.5, 0)) == 2.2, near);
}

BOOST_AUTO_TEST_CASE(a_held_gait_stays_as_it_is) {
    struct Clock : Gait {
        void keep(std::span<const int>, std::span<const Link>) override {}
        void signals(int t, std::span<double> signal) override {
            ++asked;
            std::fill(signal.begin(), signal.end(), 0.001 * t);
        }
        int asked = 0;
    };
    auto own = std::make_unique<Clock>();
    const Clock &clock = *own;
    const auto held = hold(std::move(own), 25);
    std::vector<double> signal(3), seen;
    for (int t = 0; t <= 60; t += 10) {
        held->signals(t, signal);
        BOOST_TEST((signal[0] == signal[1] && signal[1] == signal[2]));
        seen.push_back(signal[0]);
    }
    BOOST_TEST(seen == (std::vector<double>{0, 0.01, 0.02, 0.03, 0.03, 0.03, 0.03}));
    BOOST_TEST(clock.asked == 4);
}
