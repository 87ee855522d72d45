// SPDX-License-Identifier: MIT
#include "storage/packed.h"

#include "base/error.h"
#include "base/random.h"
#include "base/state.h"

#include <boost/test/unit_test.hpp>

#include <optional>
#include <string>

using namespace planula;

namespace {

std::string noise(std::size_t size) {
    Stream stream(1, 0, 0, Purpose::sampling);
    std::string bytes;
    while (bytes.size() < size) bytes.push_back(static_cast<char>(stream.below(256)));
    return bytes;
}

/// Shrinks to about half.
std::string digits(std::size_t size) {
    Stream stream(2, 0, 0, Purpose::sampling);
    std::string bytes;
    while (bytes.size() < size) bytes.push_back(static_cast<char>('0' + stream.below(10)));
    return bytes;
}

/// The bytes as a packed text: nothing if they are refused.
std::optional<std::string> unpacked(const std::string &bytes) {
    try {
        return unpack(bytes);
    } catch (const InputError &) {
        return std::nullopt;
    }
}

std::string packed(bool is_shrunk, std::int64_t length, const std::string &stored) {
    return StateWriter().group("packed").integer(is_shrunk).integer(length).text(stored).bytes();
}

constexpr std::size_t around = 64; // at most, beside the content

} // namespace

BOOST_AUTO_TEST_CASE(packed_bytes_unpack_to_the_same_bytes) {
    for (const std::string &content :
         {std::string(), std::string("a"), std::string(1000, '\0'), std::string(100'000, 'x'), noise(5000),
          digits(5000), digits(200'000), std::string("text\0with\nall", 13)})
        BOOST_TEST((unpack(pack(content)) == content));
}

BOOST_AUTO_TEST_CASE(compressible_bytes_become_shorter_and_others_hardly_longer) {
    BOOST_TEST(pack(digits(5000)).size() < 3000u);
    BOOST_TEST(pack(noise(5000)).size() <= 5000 + around);
    BOOST_TEST(pack("").size() <= around);
}

BOOST_AUTO_TEST_CASE(nothing_packed_is_more_than_16_times_as_long) {
    // Content that would shrink further is stored without packing.
    for (const std::size_t size : {100u, 1000u, 10'000u, 100'000u, 1'000'000u}) {
        const std::string content(size, 'x');
        BOOST_TEST(pack(content).size() * 16 >= size);
    }
    BOOST_TEST(pack(std::string(1'000'000, 'x')).size() > 1'000'000u);
}

BOOST_AUTO_TEST_CASE(packed_bytes_that_were_cut_or_changed_are_refused_or_mean_the_same) {
    for (const std::string &content : {digits(1000), noise(60)}) {
        const std::string whole = pack(content);
        for (std::size_t length = 0; length < whole.size(); ++length)
            BOOST_TEST(!unpacked(whole.substr(0, length)), length);
        BOOST_TEST(!unpacked(whole + '\0'));
    }
    // Only changes in bytes that are stored without packing are not noticed here; the seal finds them.
    const std::string content = digits(1000), whole = pack(content);
    for (std::size_t bit = 0; bit < whole.size() * 8; ++bit) {
        std::string flipped = whole;
        flipped[bit / 8] = static_cast<char>(flipped[bit / 8] ^ 1 << bit % 8);
        BOOST_TEST(unpacked(flipped).value_or(content) == content, bit);
    }
}

BOOST_AUTO_TEST_CASE(a_hostile_length_is_refused_before_room_is_made_for_it) {
    const std::string stored = "x\x9c\x03";
    for (const std::int64_t length : {std::int64_t{-1}, std::int64_t{1} << 62,
                                      std::numeric_limits<std::int64_t>::max(), std::int64_t{16 * 200}}) {
        BOOST_TEST(!unpacked(packed(true, length, stored)));
        BOOST_TEST(!unpacked(packed(false, length, stored)));
    }
    BOOST_TEST(!unpacked(packed(false, 2, stored)));
    BOOST_TEST(!unpacked(packed(false, 4, stored)));
    BOOST_TEST(unpacked(packed(false, 3, stored)).value() == stored);
}

BOOST_AUTO_TEST_CASE(a_compressed_text_of_another_length_or_with_something_behind_it_is_refused) {
    const std::string content = digits(1000), whole = pack(content);
    StateReader reader(whole);
    reader.group("packed");
    BOOST_REQUIRE(reader.integer() == 1);
    BOOST_REQUIRE(reader.integer() == 1000);
    const std::string stored = reader.text();
    BOOST_TEST(unpacked(packed(true, 1000, stored)).value() == content);
    BOOST_TEST(!unpacked(packed(true, 999, stored)));
    BOOST_TEST(!unpacked(packed(true, 1001, stored)));
    BOOST_TEST(!unpacked(packed(true, 1000, stored + "more")));
    BOOST_TEST(!unpacked(packed(true, 1000, stored.substr(0, stored.size() - 1))));
}
