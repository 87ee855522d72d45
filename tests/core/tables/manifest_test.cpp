// SPDX-License-Identifier: MIT
#include "tables/manifest.h"

#include "base/error.h"
#include "core/storage/temporary_folder.h"

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

BOOST_AUTO_TEST_CASE(a_row_that_a_manifest_lacks_is_named) {
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

BOOST_AUTO_TEST_CASE(a_seal_shows_every_change_of_a_row) {
    const TemporaryFolder folder;
    Manifest manifest;
    manifest.add("title", "one, two");
    manifest.add("count", 4);
    manifest.seal();
    manifest.check_seal();
    manifest.write(folder.path());
    Manifest(folder.path()).check_seal();
    const std::string whole = read_bytes(folder / "manifest.csv");
    const auto refused = [&](const std::string &text) {
        write_bytes(folder / "manifest.csv", text);
        BOOST_TEST(message_of<InputError>([&] { Manifest(folder.path()).check_seal(); }) ==
                   (folder / "manifest.csv").string() +
                       ": it is not as it was written: its last row is not the hash of the others");
    };
    refused("key,value\n");
    refused(replaced(whole, "count,4", "count,5"));
    refused(replaced(whole, "count,4", "cound,4"));
    refused(replaced(whole, "count,4\n", ""));
    refused(replaced(whole, "count,4\n", "count,4\nmore,1\n"));
    refused(whole + "more,1\n");
    refused(replaced(whole, "manifest_sha256", "manifest_sha257"));
    refused(whole.substr(0, whole.find("manifest_sha256")));
}

BOOST_AUTO_TEST_CASE(a_count_is_a_number_of_one_or_more_that_fits) {
    const TemporaryFolder folder;
    write_bytes(folder / "manifest.csv",
                "key,value\none,1\nmost,2147483647\nnone,0\nless,-1\nmore,2147483648\n");
    const Manifest manifest(folder.path());
    BOOST_TEST(manifest.count("one") == 1);
    BOOST_TEST(manifest.count("most") == 2147483647);
    for (const char *key : {"none", "less", "more"})
        BOOST_TEST(contains(message_of<InputError>([&] { manifest.count(key); }), " is not a count"), key);
}
