// SPDX-License-Identifier: MIT
#include "base/text.h"

#include "base/random.h"

#include <boost/test/unit_test.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

using namespace planula;

BOOST_AUTO_TEST_CASE(numbers_round_trip_to_the_bit) {
    Stream stream(1, 0, 0, Purpose::sampling);
    for (int i = 0; i < 20000; ++i) {
        const std::uint64_t high = stream.bits(), bits = high << 32 | stream.bits();
        const double value = std::bit_cast<double>(bits);
        if (!std::isfinite(value)) continue;
        const auto read = parse_double(to_text(value));
        BOOST_REQUIRE((read && std::bit_cast<std::uint64_t>(*read) == bits));
    }
    BOOST_TEST(to_text(0.1) == "0.1");
    BOOST_TEST(to_fixed(2.0 / 3, 2) == "0.67");
    for (const double sign : {1.0, -1.0})
        BOOST_TEST(to_text(std::copysign(std::numeric_limits<double>::quiet_NaN(), sign)) == "nan");
}

BOOST_AUTO_TEST_CASE(a_noun_follows_its_number) {
    BOOST_TEST(counted(1, "run") == "1 run");
    BOOST_TEST(counted(0, "run") == "0 runs");
    BOOST_TEST(counted(std::size_t{2}, "kept state") == "2 kept states");
}

BOOST_AUTO_TEST_CASE(only_whole_texts_are_numbers) {
    for (const char *text : {"", " 1", "1 ", "1,5", "0x10", "1e", "--1", "+1", "ten"})
        BOOST_TEST(!parse_double(text));
    for (const char *text : {"", "1.0", "1e3", "9223372036854775808", " 7"}) BOOST_TEST(!parse_int(text));
    BOOST_TEST(*parse_int("-42") == -42);
    BOOST_TEST(!parse_double("1e999"));
}

BOOST_AUTO_TEST_CASE(the_nearest_name_is_a_likely_one_or_none) {
    const std::vector<std::string> names{"gravity", "friction", "flow"};
    BOOST_TEST(nearest_name("gravty", names) == "gravity");
    BOOST_TEST(nearest_name("frictoin", names) == "friction");
    BOOST_TEST(nearest_name("temperature", names) == "");
    BOOST_TEST(edit_distance("kitten", "sitting") == 3u);
}
