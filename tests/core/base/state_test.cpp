// SPDX-License-Identifier: MIT
#include "base/state.h"

#include "base/error.h"

#include <boost/test/unit_test.hpp>

#include <bit>
#include <limits>

using namespace planula;

namespace {

std::string sample() {
    StateWriter writer;
    writer.group("first").integer(-1).integer(std::numeric_limits<std::int64_t>::min()).real(-0.0).real(0.1);
    writer.group("second").text("").text(std::string("a\0b\xff", 4)).integer(2).real(1).real(2);
    return writer.bytes();
}

void read(std::string_view bytes) {
    StateReader reader(bytes);
    reader.group("first");
    BOOST_TEST(reader.integer() == -1);
    BOOST_TEST(reader.integer() == std::numeric_limits<std::int64_t>::min());
    BOOST_TEST(std::bit_cast<std::uint64_t>(reader.real()) == 0x8000000000000000u);
    BOOST_TEST(reader.finite() == 0.1);
    reader.group("second");
    BOOST_TEST(reader.text() == "");
    BOOST_TEST(reader.text() == std::string("a\0b\xff", 4));
    BOOST_REQUIRE(reader.count() == 2u);
    BOOST_TEST(reader.real() == 1);
    BOOST_TEST(reader.real() == 2);
    reader.done();
}

} // namespace

BOOST_AUTO_TEST_CASE(state_reads_back_to_the_bit) { read(sample()); }

BOOST_AUTO_TEST_CASE(state_is_the_same_bytes_on_every_machine) {
    BOOST_TEST(StateWriter().integer(0x0102).bytes() == std::string("\2\1\0\0\0\0\0\0", 8));
    BOOST_TEST(StateWriter().real(1).bytes() == std::string("\0\0\0\0\0\0\xf0\x3f", 8));
    BOOST_TEST(StateWriter().text("ab").bytes() == std::string("\2\0\0\0\0\0\0\0ab", 10));
}

BOOST_AUTO_TEST_CASE(state_cut_short_or_with_something_left_is_refused) {
    const std::string whole = sample();
    for (std::size_t length = 0; length < whole.size(); ++length) {
        StateReader reader(std::string_view(whole).substr(0, length));
        const auto read_all = [&] {
            reader.group("first");
            for (int i = 0; i < 2; ++i) reader.integer();
            for (int i = 0; i < 2; ++i) reader.real();
            reader.group("second");
            reader.text(), reader.text();
            for (std::size_t left = reader.count(); left > 0; --left) reader.real();
            reader.done();
        };
        BOOST_CHECK_THROW(read_all(), InputError);
    }
    BOOST_CHECK_THROW(StateReader(whole).done(), InputError);
}

BOOST_AUTO_TEST_CASE(lengths_and_numbers_out_of_range_are_refused_before_anything_is_made_of_them) {
    const std::string endless = StateWriter().integer(-1).bytes();
    BOOST_CHECK_THROW(StateReader(endless).text(), InputError);
    BOOST_CHECK_THROW(StateReader(endless).count(), InputError);
    const std::string five = StateWriter().integer(5).real(1).bytes();
    BOOST_CHECK_THROW(StateReader(five).count(), InputError);
    BOOST_CHECK_THROW(StateReader(five).integer(0, 4), InputError);
    BOOST_CHECK_THROW(StateReader(StateWriter().integer(1LL << 40).bytes()).small_integer(), InputError);
    const std::string infinite = StateWriter().real(std::numeric_limits<double>::infinity()).bytes();
    BOOST_CHECK_THROW(StateReader(infinite).finite(), InputError);
}

BOOST_AUTO_TEST_CASE(a_refusal_names_group_byte_and_rule) {
    const std::string bytes = StateWriter().group("archive").integer(9).bytes();
    StateReader reader(bytes);
    reader.group("archive");
    const auto says = [](const InputError &error) {
        return std::string_view(error.what()) ==
               "saved state, byte 23, in 'archive': 9 is not between 0 and 4";
    };
    BOOST_CHECK_EXCEPTION(reader.integer(0, 4), InputError, says);
}
