// SPDX-License-Identifier: MIT
#include "evaluation/rhythm.h"

#include "base/math.h"
#include "base/random.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <functional>

using namespace planula;

namespace {

/// 200 samples of some cells.
Samples sampled(int cells, const std::function<double(int t, int cell)> &signal) {
    Samples samples(200);
    for (int t = 0; t < 200; ++t)
        for (int cell = 0; cell < cells; ++cell)
            samples[static_cast<std::size_t>(t)].push_back(signal(t, cell));
    return samples;
}

/// A sine; the cell's phase in periods.
double sine(double t, double period, double phase) { return math::sin(2 * math::pi * (t / period + phase)); }

} // namespace

BOOST_AUTO_TEST_CASE(the_period_of_a_sine_is_found_between_samples) {
    for (const double period : {10.0, 12.5, 17.3, 26.0, 40.0})
        BOOST_TEST(period_of(sampled(1, [&](int t, int) { return sine(t, period, 0.1); })) == period,
                   boost::test_tools::tolerance(0.005));
}

BOOST_AUTO_TEST_CASE(a_travelling_wave_whose_mean_is_zero_has_its_period_and_its_phases) {
    const Samples wave = sampled(8, [](int t, int cell) { return 0.3 + sine(t, 20, -cell / 8.0); });
    BOOST_TEST(period_of(wave) == 20, boost::test_tools::tolerance(0.005));
    const std::vector<double> phases = phases_of(wave, 20);
    for (int cell = 0; cell < 8; ++cell) {
        const double expected = cell <= 4 ? -cell / 8.0 : 1 - cell / 8.0;
        const double apart = phases[static_cast<std::size_t>(cell)] - expected;
        BOOST_TEST(std::abs(apart - std::round(apart)) < 1e-9);
        BOOST_TEST(std::abs(phases[static_cast<std::size_t>(cell)]) <= 0.5 + 1e-9);
    }
}

BOOST_AUTO_TEST_CASE(a_rhythm_with_harmonics_has_the_period_after_which_it_repeats) {
    BOOST_TEST(period_of(sampled(1, [](int t, int) { return sine(t, 30, 0) + 0.5 * sine(t, 10, 0); })) == 30,
               boost::test_tools::tolerance(0.01));
    BOOST_TEST(period_of(sampled(1, [](int t, int) { return t / 7 % 2 == 0 ? 1.0 : -1.0; })) == 14,
               boost::test_tools::tolerance(0.01));
}

BOOST_AUTO_TEST_CASE(without_a_rhythm_the_period_is_zero) {
    Stream stream(1, 0, 0, Purpose::start);
    BOOST_TEST(period_of(sampled(3, [](int, int) { return 0.7; })) == 0);
    BOOST_TEST(period_of(sampled(2, [](int t, int) { return t < 100 ? 0.0 : 1.0; })) == 0);
    BOOST_TEST(period_of(sampled(2, [](int t, int) { return t / 200.0; })) == 0);
    BOOST_TEST(period_of(sampled(2, [&](int, int) { return stream.uniform(); })) == 0);
    BOOST_TEST(period_of(Samples{}) == 0);
    BOOST_TEST(period_of(Samples(3, std::vector<double>{1})) == 0);
    // A period must fit twice.
    BOOST_TEST(period_of(sampled(1, [](int t, int) { return sine(t, 150, 0); })) == 0);
}
