// SPDX-License-Identifier: MIT
#include "base/hash.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(sha256_gives_the_examples_of_fips_180) {
    BOOST_TEST(sha256("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    BOOST_TEST(sha256("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    BOOST_TEST(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq") ==
               "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
    BOOST_TEST(sha256(std::string(1000000, 'a')) ==
               "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

BOOST_AUTO_TEST_CASE(pieces_hash_as_the_whole_wherever_they_are_cut) {
    const std::string text(200, 'x');
    for (std::size_t cut = 0; cut <= text.size(); ++cut) {
        Hash hash;
        hash.bytes(text.data(), cut).bytes(text.data() + cut, text.size() - cut);
        BOOST_REQUIRE(hash.hex() == sha256(text));
    }
}

BOOST_AUTO_TEST_CASE(texts_keep_their_borders_and_zeros_their_sign) {
    BOOST_TEST(Hash().text("ab").text("c").hex() != Hash().text("a").text("bc").hex());
    BOOST_TEST(Hash().number(0.0).hex() != Hash().number(-0.0).hex());
}
