// SPDX-License-Identifier: MIT
#include "record/manifest.h"

#include "base/error.h"
#include "core/record/fake_run.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_manifest_comes_back_in_its_order) {
    const TemporaryFolder folder;
    Manifest manifest;
    manifest.add("title", "one, two");
    manifest.add("count", std::int64_t{1} << 40);
    manifest.write(folder.path());
    const Manifest back(folder.path());
    BOOST_TEST(back.text("title") == "one, two");
    BOOST_TEST(back.number("count") == std::int64_t{1} << 40);
    BOOST_TEST(back.rows().front().key == "title");
    BOOST_TEST(!back.has("status"));
}

BOOST_AUTO_TEST_CASE(what_a_manifest_lacks_is_named) {
    const TemporaryFolder folder;
    write_bytes(folder / "manifest.csv", "key,value\nseed,three\n");
    const Manifest manifest(folder.path());
    const std::string file = (folder / "manifest.csv").string();
    BOOST_TEST(message_of<InputError>([&] { manifest.text("status"); }) == file + ": no row 'status'");
    BOOST_TEST(message_of<InputError>([&] { manifest.number("seed"); }) ==
               file + ": 'seed' = 'three' is not a whole number");
}

BOOST_AUTO_TEST_CASE(a_key_that_is_there_twice_is_refused) {
    const TemporaryFolder folder;
    write_bytes(folder / "manifest.csv", "key,value\nseed,1\nseed,2\n");
    BOOST_TEST(message_of<InputError>([&] { Manifest manifest(folder.path()); }) ==
               (folder / "manifest.csv").string() + ":3: the key 'seed' is there twice");
}

BOOST_AUTO_TEST_CASE(the_version_has_three_numbers) {
    BOOST_TEST(std::count(version().begin(), version().end(), '.') == 2);
    BOOST_TEST(contains(compiler(), "."));
}
