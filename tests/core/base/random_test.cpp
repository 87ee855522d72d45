// SPDX-License-Identifier: MIT
#include "base/random.h"

#include <boost/test/unit_test.hpp>

#include <array>
#include <vector>

using namespace planula;
using Block = std::array<std::uint32_t, 4>;

BOOST_AUTO_TEST_CASE(philox_gives_the_known_answers_of_random123) {
    // kat_vectors of Random123 1.14 (Salmon et al. 2011), philox4x32 with 10 rounds.
    const std::uint32_t ones = 0xffffffff;
    const Block zero = philox({0, 0, 0, 0}, {0, 0});
    const Block full = philox({ones, ones, ones, ones}, {ones, ones});
    const Block pi = philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0});
    BOOST_TEST(zero == (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
    BOOST_TEST(full == (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
    BOOST_TEST(pi == (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

BOOST_AUTO_TEST_CASE(every_part_of_a_streams_name_makes_another_stream) {
    const auto first = [](Stream stream) { return std::pair(stream.bits(), stream.bits()); };
    const auto base = first(Stream(1, 2, 3, Purpose::reproduction));
    BOOST_TEST((base == first(Stream(1, 2, 3, Purpose::reproduction))));
    BOOST_TEST((base != first(Stream(2, 2, 3, Purpose::reproduction))));
    BOOST_TEST((base != first(Stream(1 + (std::uint64_t{1} << 32), 2, 3, Purpose::reproduction))));
    BOOST_TEST((base != first(Stream(1, 3, 3, Purpose::reproduction))));
    BOOST_TEST((base != first(Stream(1, 2, 4, Purpose::reproduction))));
    BOOST_TEST((base != first(Stream(1, 2, 3, Purpose::bootstrap))));
}

BOOST_AUTO_TEST_CASE(uniform_draws_fill_the_unit_interval_evenly) {
    Stream stream(7, 0, 0, Purpose::sampling);
    std::array<int, 10> tenths{};
    for (int i = 0; i < 100000; ++i) {
        const double u = stream.uniform();
        BOOST_REQUIRE((u >= 0 && u < 1));
        ++tenths[static_cast<std::size_t>(u * 10)];
    }
    double chi_square = 0;
    for (const int count : tenths) chi_square += (count - 10000.0) * (count - 10000.0) / 10000;
    BOOST_TEST(chi_square < 27.9); // 0.1 % point of 9 degrees of freedom
}

BOOST_AUTO_TEST_CASE(triangular_draws_have_mean_zero_and_variance_one_sixth) {
    Stream stream(7, 0, 1, Purpose::sampling);
    double sum = 0, squares = 0;
    for (int i = 0; i < 100000; ++i) {
        const double u = stream.triangular();
        sum += u, squares += u * u;
    }
    BOOST_TEST(std::abs(sum / 100000) < 0.006);
    BOOST_TEST(std::abs(squares / 100000 - 1.0 / 6) < 0.003);
}

BOOST_AUTO_TEST_CASE(below_is_even_even_where_the_count_does_not_divide_two_to_the_32) {
    // With a count of 3 * 2^30 a plain remainder would draw the lowest third twice as often.
    Stream stream(7, 0, 2, Purpose::sampling);
    const std::uint32_t count = 3u << 30;
    int low = 0;
    for (int i = 0; i < 30000; ++i) low += stream.below(count) < count / 3;
    BOOST_TEST(std::abs(low - 10000) < 400);
    BOOST_TEST(stream.below(1) == 0u);
}
