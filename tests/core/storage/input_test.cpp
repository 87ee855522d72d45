// SPDX-License-Identifier: MIT
#include "storage/input.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "core/storage/temporary_folder.h"
#include "storage/output.h"

#include <boost/test/unit_test.hpp>

#include <sys/stat.h>
#include <unistd.h>

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

BOOST_AUTO_TEST_CASE(a_folder_and_a_pipe_without_a_writer_are_refused_at_once) {
    const TemporaryFolder folder;
    const std::filesystem::path pipe = folder / "pipe";
    BOOST_REQUIRE(::mkfifo(pipe.c_str(), 0600) == 0);
    for (const auto &path : {folder.path(), pipe}) {
        BOOST_TEST(refusal(path) == path.string() + ": is not a file");
        BOOST_TEST(message_of<InputError>([&] { read_file(path); }) == path.string() + ": is not a file");
    }
}

BOOST_AUTO_TEST_CASE(a_file_below_a_file_is_as_one_that_is_not_there) {
    const TemporaryFolder folder;
    write_file(folder / "file", "");
    BOOST_TEST(contains(refusal(folder / "file/table.csv"), "Not a directory"));
}

BOOST_AUTO_TEST_CASE(a_file_that_may_not_be_read_is_an_io_error) {
    const TemporaryFolder folder;
    // Links in a circle are refused for every user; a file without permission only if the tests do not run as root.
    std::filesystem::create_symlink(folder / "circle", folder / "circle");
    BOOST_TEST(contains(message_of<IoError>([&] { content_sha256(folder / "circle"); }),
                        "cannot open " + (folder / "circle").string() + ": "));
    write_file(folder / "secret", "text");
    std::filesystem::permissions(folder / "secret", std::filesystem::perms::none);
    if (::access((folder / "secret").c_str(), R_OK) == 0) return;
    BOOST_TEST(
        contains(message_of<IoError>([&] { content_sha256(folder / "secret"); }), "Permission denied"));
}

BOOST_AUTO_TEST_CASE(files_of_any_size_are_read_whole) {
    const TemporaryFolder folder;
    for (const std::size_t size : {0, 1, 65'535, 65'536, 65'537, 300'000}) {
        std::string text(size, 'a');
        for (std::size_t at = 0; at < size; at += 7) text[at] = static_cast<char>('b' + at % 13);
        write_file(folder / "plain", text);
        write_file(folder / "packed.gz", text);
        BOOST_TEST((read_file(folder / "plain") == text));
        BOOST_TEST((read_file(folder / "packed.gz") == text));
    }
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
