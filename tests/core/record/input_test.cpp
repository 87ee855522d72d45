// SPDX-License-Identifier: MIT
#include "record/input.h"

#include "base/error.h"
#include "base/hash.h"
#include "core/record/fake_run.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::string refusal(const std::filesystem::path &path) {
    return message_of<InputError>([&] { content_sha256(path); });
}

} // namespace

BOOST_AUTO_TEST_CASE(a_missing_file_is_named_with_the_reason) {
    const TemporaryFolder folder;
    BOOST_TEST(refusal(folder / "curves.csv") ==
               "cannot open " + (folder / "curves.csv").string() + ": No such file or directory");
}

BOOST_AUTO_TEST_CASE(a_folder_cannot_be_read_as_a_file) {
    const TemporaryFolder folder;
    BOOST_CHECK_THROW(content_sha256(folder.path()), IoError);
}

BOOST_AUTO_TEST_CASE(the_content_of_a_packed_file_has_the_hash_of_its_plain_text) {
    const TemporaryFolder folder;
    const std::string text(100'000, 'a');
    write_file(folder / "plain", text);
    write_file(folder / "packed.gz", text);
    BOOST_TEST(content_sha256(folder / "plain") == sha256(text));
    BOOST_TEST(content_sha256(folder / "packed.gz") == sha256(text));
    BOOST_TEST(read_bytes(folder / "packed.gz").size() < 1000u);
}

BOOST_AUTO_TEST_CASE(a_packed_file_cut_off_anywhere_is_refused) {
    const TemporaryFolder folder;
    std::string text;
    for (int i = 0; i < 500; ++i) text += to_text(i * i) + ",";
    write_file(folder / "whole.gz", text);
    const std::string bytes = read_bytes(folder / "whole.gz");
    for (std::size_t size = 1; size < bytes.size(); ++size) {
        write_bytes(folder / "cut.gz", bytes.substr(0, size));
        BOOST_TEST(!refusal(folder / "cut.gz").empty(), size);
    }
}

BOOST_AUTO_TEST_CASE(a_changed_byte_of_packed_data_is_refused) {
    const TemporaryFolder folder;
    std::string text;
    for (int i = 0; i < 500; ++i) text += to_text(i * i) + ",";
    const std::string hash = write_file(folder / "whole.gz", text);
    const std::string bytes = read_bytes(folder / "whole.gz");
    constexpr std::size_t header = 10; // whose time and system fields say nothing about the content
    for (std::size_t at = header; at < bytes.size(); ++at) {
        std::string changed = bytes;
        changed[at] ^= 0x10;
        write_bytes(folder / "changed.gz", changed);
        std::string found;
        const std::string said =
            message_of<InputError>([&] { found = content_sha256(folder / "changed.gz"); });
        BOOST_TEST((!said.empty() || found == hash), at);
        BOOST_TEST((said.empty() || contains(said, "changed.gz: ")), said);
    }
}

BOOST_AUTO_TEST_CASE(plain_text_under_a_packed_name_is_refused) {
    const TemporaryFolder folder;
    write_bytes(folder / "plain.gz", "a,b\n");
    BOOST_TEST(refusal(folder / "plain.gz") == (folder / "plain.gz").string() + ": not a gzip file");
}
