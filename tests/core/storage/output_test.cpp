// SPDX-License-Identifier: MIT
#include "storage/output.h"

#include "base/error.h"
#include "base/text.h"
#include "core/storage/temporary_folder.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::size_t entries(const std::filesystem::path &folder) {
    std::size_t count = 0;
    for ([[maybe_unused]] const auto &entry : std::filesystem::directory_iterator(folder)) ++count;
    return count;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_file_appears_only_when_it_is_whole) {
    const TemporaryFolder folder;
    Output output(folder / "table.csv");
    output.write("first\n");
    output.write(std::string(200'000, 'x'));
    BOOST_TEST(!std::filesystem::exists(folder / "table.csv"));
    const std::string hash = output.commit();
    BOOST_TEST(read_bytes(folder / "table.csv") == "first\n" + std::string(200'000, 'x'));
    BOOST_TEST(hash == sha256("first\n" + std::string(200'000, 'x')));
    BOOST_TEST(entries(folder.path()) == 1u);
}

BOOST_AUTO_TEST_CASE(an_abandoned_file_leaves_what_was_there) {
    const TemporaryFolder folder;
    write_file(folder / "table.csv", "old");
    {
        Output output(folder / "table.csv");
        output.write("new");
    }
    BOOST_TEST(read_bytes(folder / "table.csv") == "old");
    BOOST_TEST(entries(folder.path()) == 1u);
}

BOOST_AUTO_TEST_CASE(equal_content_is_packed_to_equal_bytes_however_it_comes) {
    const TemporaryFolder folder;
    std::string text;
    for (int i = 0; i < 40'000; ++i) text += to_text(i * 7919 % 1000) + (i % 10 == 9 ? "\n" : ",");
    write_file(folder / "whole.gz", text);
    Output pieces(folder / "pieces.gz");
    for (std::size_t at = 0; at < text.size(); at += 37) pieces.write(std::string_view(text).substr(at, 37));
    pieces.commit();
    const std::string bytes = read_bytes(folder / "whole.gz");
    BOOST_TEST((bytes == read_bytes(folder / "pieces.gz")));
    // RFC 1952: bytes 4 to 7 are the time, byte 3 the flags of name and comment.
    BOOST_TEST((bytes.substr(3, 5) == std::string(5, '\0')));
}

BOOST_AUTO_TEST_CASE(a_folder_that_is_not_there_cannot_be_written_to) {
    const TemporaryFolder folder;
    const std::filesystem::path path = folder / "missing" / std::filesystem::path("table.csv");
    BOOST_TEST(message_of<CreateError>([&] { Output output(path); }) ==
               "cannot create " + path.string() + ": No such file or directory");
}

BOOST_AUTO_TEST_CASE(a_folder_cannot_be_made_where_a_file_is) {
    const TemporaryFolder folder;
    write_file(folder / "file", "");
    const std::string said =
        message_of<CreateError>([&] { make_folder(folder / "file" / std::filesystem::path("x")); });
    BOOST_TEST(contains(said, "cannot create folder " + (folder / "file").string()));
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_an_error_that_names_the_file_and_keeps_the_old_one) {
    for (const std::string name : {"table.csv", "table.csv.gz"}) {
        const TemporaryFolder folder;
        write_bytes(folder / name, "old");
        std::filesystem::create_symlink("/dev/full", folder / (name + ".tmp"));
        const std::string said = message_of<IoError>([&] {
            Output output(folder / name);
            output.write("short enough to wait in memory\n");
            output.commit();
        });
        BOOST_TEST(said == "cannot write " + (folder / name).string() + ": No space left on device");
        BOOST_TEST(read_bytes(folder / name) == "old");
    }
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_found_while_writing) {
    const TemporaryFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "table.csv.tmp");
    Output output(folder / "table.csv");
    BOOST_CHECK_THROW(output.write(std::string(1'000'000, 'x')), IoError);
}

BOOST_AUTO_TEST_CASE(removing_what_is_not_there_is_no_error) {
    const TemporaryFolder folder;
    write_file(folder / "a", "");
    remove_file(folder / "a");
    remove_file(folder / "a");
    BOOST_TEST(entries(folder.path()) == 0u);
}

BOOST_AUTO_TEST_CASE(a_folder_is_held_by_one_at_a_time) {
    const TemporaryFolder folder;
    {
        const FolderLock lock(folder.path());
        BOOST_TEST(message_of<CreateError>([&] { FolderLock second(folder.path()); }) ==
                   folder.path().string() + " is in use by another process");
    }
    const FolderLock again(folder.path());
}

BOOST_AUTO_TEST_CASE(a_copy_has_the_same_bytes_and_replaces_nothing) {
    const TemporaryFolder folder;
    for (const std::size_t size : {0, 1, 65'536, 200'000}) {
        std::string bytes(size, 'x');
        for (std::size_t at = 0; at < size; at += 3) bytes[at] = static_cast<char>(at % 251);
        write_bytes(folder / "from", bytes);
        planula::copy_file(folder / "from", folder / "to");
        BOOST_TEST((read_bytes(folder / "to") == bytes));
        BOOST_CHECK_THROW(planula::copy_file(folder / "from", folder / "to"), CreateError);
        std::filesystem::remove(folder / "to");
    }
    BOOST_CHECK_THROW(planula::copy_file(folder / "nowhere", folder / "to"), IoError);
    BOOST_TEST(!std::filesystem::exists(folder / "to"));
    BOOST_CHECK_THROW(planula::copy_file(folder / "from", "/dev/full"), CreateError);
}
