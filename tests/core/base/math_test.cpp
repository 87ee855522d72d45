// SPDX-License-Identifier: MIT
// The models are the long double functions of the C library, whose errors lie far below a double's last
// place.
#include "base/math.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <limits>

using namespace planula;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The largest distance in units of the last place between f and its long double model over [low, high].
template <class F, class Model> double worst_ulps(F f, Model model, double low, double high) {
    double worst = 0;
    constexpr int points = 20011;
    for (int i = 0; i <= points; ++i) {
        const double x = low + (high - low) * i / points;
        const long double truth = model(static_cast<long double>(x));
        const double rounded = static_cast<double>(truth);
        const double ulp = std::nextafter(std::abs(rounded), infinity) - std::abs(rounded);
        worst = std::max(worst, static_cast<double>(std::abs(f(x) - truth)) / ulp);
    }
    return worst;
}

} // namespace

BOOST_AUTO_TEST_CASE(elementary_functions_are_accurate_to_a_few_units_in_the_last_place) {
    using L = long double;
    BOOST_TEST(worst_ulps(
                   math::sin, [](L x) { return std::sin(x); }, -100, 100) < 3);
    BOOST_TEST(worst_ulps(
                   math::cos, [](L x) { return std::cos(x); }, -100, 100) < 3);
    BOOST_TEST(worst_ulps(
                   math::exp, [](L x) { return std::exp(x); }, -700, 700) < 1.5);
    BOOST_TEST(worst_ulps(
                   math::log, [](L x) { return std::log(x); }, 1e-3, 1e3) < 1.5);
    BOOST_TEST(worst_ulps(
                   math::tanh, [](L x) { return std::tanh(x); }, -22, 22) < 3);
    BOOST_TEST(worst_ulps(
                   math::tanh, [](L x) { return std::tanh(x); }, -0.01, 0.01) < 3);
    BOOST_TEST(worst_ulps(
                   math::atan, [](L x) { return std::atan(x); }, -50, 50) < 5);
}

BOOST_AUTO_TEST_CASE(erfc_keeps_thirteen_digits_far_into_the_tail) {
    for (const double x : {-3.0, -0.5, 0.0, 0.3, 1.0, 1.4999, 1.5, 2.0, 5.0, 10.0, 26.0}) {
        const double truth = static_cast<double>(std::erfc(static_cast<long double>(x)));
        BOOST_TEST(math::erfc(x) == truth, boost::test_tools::tolerance(1e-13));
    }
}

BOOST_AUTO_TEST_CASE(results_are_these_bits_on_every_machine) {
    // Recorded once; a compiler that fuses or reorders an operation changes one of them.
    BOOST_TEST(math::sin(1.0) == 0x1.aed548f090ceep-1);
    BOOST_TEST(math::cos(10.0) == -0x1.ad9ac890c6b1fp-1);
    BOOST_TEST(math::exp(1.0) == 0x1.5bf0a8b14576ap+1);
    BOOST_TEST(math::log(10.0) == 0x1.26bb1bbb55516p+1);
    BOOST_TEST(math::tanh(0.5) == 0x1.d9353d7568af3p-2);
}

BOOST_AUTO_TEST_CASE(limits_and_odd_arguments_have_their_values) {
    BOOST_TEST(std::isnan(math::sin(infinity)));
    BOOST_TEST(math::exp(-infinity) == 0);
    BOOST_TEST(math::exp(800) == infinity);
    BOOST_TEST(math::exp(-740) > 0);
    BOOST_TEST(math::log(0) == -infinity);
    BOOST_TEST(std::isnan(math::log(-1)));
    BOOST_TEST(math::log(0x1p-1074) == -1074 * std::log(2.0), boost::test_tools::tolerance(1e-15));
    BOOST_TEST(math::tanh(1e300) == 1);
    BOOST_TEST(math::tanh(-infinity) == -1);
    BOOST_TEST(std::signbit(math::tanh(-0.0)));
    for (auto f : {math::sin, math::cos, math::exp, math::log, math::tanh, math::atan, math::erfc})
        BOOST_TEST(std::isnan(f(std::numeric_limits<double>::quiet_NaN())));
}

BOOST_AUTO_TEST_CASE(atan2_has_the_quadrant_of_the_point) {
    BOOST_TEST(math::atan2(1, 1) == math::pi / 4, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(math::atan2(1, -1) == 3 * math::pi / 4, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(math::atan2(-1, -1) == -3 * math::pi / 4, boost::test_tools::tolerance(1e-15));
    BOOST_TEST(math::atan2(-2, 0) == -math::pi / 2);
    BOOST_TEST(math::atan2(0, -1) == math::pi);
    BOOST_TEST(math::atan2(0, 1) == 0);
}

BOOST_AUTO_TEST_CASE(whole_powers_are_products) {
    BOOST_TEST(math::pow(3, 4) == 81);
    BOOST_TEST(math::pow(-2, 3) == -8);
    BOOST_TEST(math::pow(2, -2) == 0.25);
    BOOST_TEST(math::pow(0, 0) == 1);
    BOOST_TEST(math::pow(2, 0.5) == std::sqrt(2.0), boost::test_tools::tolerance(1e-14));
    BOOST_TEST(std::isnan(math::pow(-2, 0.5)));
}
