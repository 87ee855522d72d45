// SPDX-License-Identifier: MIT
#include "recording/packed_numbers.h"

#include "support/recordings.h"

#include <boost/test/unit_test.hpp>

#include <limits>

using namespace planula;
using namespace planula::test;

BOOST_AUTO_TEST_CASE(series_survive_packing_in_every_order) {
    const std::vector<std::int64_t> large{
        0, 1, -1, 15, 16, -15, -16, 511, 512, -100000, 1 << 30, -(1 << 30), 1LL << 50, -(1LL << 50), 0};
    for (int order = 0; order <= 2; ++order) {
        std::string text;
        pack_series(large, order, text);
        BOOST_TEST(summed(unpack_numbers(text), order) == large, boost::test_tools::per_element());
        text.clear();
        pack_series({}, order, text);
        BOOST_TEST(text.empty());
    }
}

BOOST_AUTO_TEST_CASE(small_numbers_take_one_character_as_source_maps_write_them) {
    // The example of the proposal: 16 is "gB", and -15 … 15 are single characters.
    std::string text;
    pack_series(std::vector<std::int64_t>{0, 1, -1, 15, -15, 16}, 0, text);
    BOOST_TEST(text == "ACDefgB");
}

BOOST_AUTO_TEST_CASE(values_are_rounded_to_the_nearest_unit_and_never_undefined) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    BOOST_TEST(quantised(1.0 / 512, 256) == 1);
    BOOST_TEST(quantised(-1.0 / 512, 256) == 0);
    BOOST_TEST(quantised(-3.14159, 100) == -314);
    BOOST_TEST(quantised(std::numeric_limits<double>::quiet_NaN(), 256) == 0);
    BOOST_TEST(quantised(infinity, 256) == 1LL << 50);
    BOOST_TEST(quantised(-infinity, 256) == -(1LL << 50));
}
