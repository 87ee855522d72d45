// SPDX-License-Identifier: MIT
#include "record/archive_table.h"

#include "base/error.h"
#include "core/record/fake_run.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::vector<ArchiveEntry> entries(std::size_t length) {
    std::vector<ArchiveEntry> list;
    for (int i = 0; i < 5; ++i)
        list.push_back({i / 2, 100 + i, std::vector<double>(length, i / 3.0), 0.5 + i / 7.0});
    return list;
}

std::string first_line(const std::filesystem::path &path) {
    const std::string bytes = read_bytes(path);
    return bytes.substr(0, bytes.find('\n'));
}

} // namespace

BOOST_AUTO_TEST_CASE(an_archive_comes_back_whatever_the_length_of_its_descriptors) {
    for (const std::size_t length : {0, 1, 2, 3, 5}) {
        const TemporaryFolder folder;
        ArchiveWriter writer(folder.path());
        for (const ArchiveEntry &entry : entries(length)) writer.write(entry);
        writer.commit();
        const auto back = read_archive(folder.path());
        const auto expected = entries(length);
        BOOST_REQUIRE(back.size() == expected.size());
        for (std::size_t i = 0; i < back.size(); ++i) {
            BOOST_TEST(back[i].generation == expected[i].generation);
            BOOST_TEST(back[i].genome == expected[i].genome);
            BOOST_TEST(back[i].novelty == expected[i].novelty);
            BOOST_TEST((back[i].behaviour == expected[i].behaviour));
        }
    }
}

BOOST_AUTO_TEST_CASE(two_numbers_are_x_and_y_and_others_are_counted) {
    const TemporaryFolder folder;
    const auto header_with = [&](std::size_t length) {
        ArchiveWriter writer(folder.path());
        writer.write(entries(length).front());
        writer.commit();
        return first_line(folder / "archive.csv");
    };
    BOOST_TEST(header_with(2) == "generation,genome,novelty,x,y");
    BOOST_TEST(header_with(1) == "generation,genome,novelty,behaviour_1");
    BOOST_TEST(header_with(3) == "generation,genome,novelty,behaviour_1,behaviour_2,behaviour_3");
}

BOOST_AUTO_TEST_CASE(an_empty_archive_is_a_table_without_rows) {
    const TemporaryFolder folder;
    ArchiveWriter(folder.path()).commit();
    BOOST_TEST(read_bytes(folder / "archive.csv") == "generation,genome,novelty,x,y\n");
    BOOST_TEST(read_archive(folder.path()).empty());
}

BOOST_AUTO_TEST_CASE(a_foreign_header_is_refused) {
    const TemporaryFolder folder;
    write_bytes(folder / "archive.csv", "generation,genome,novelty,x,z\n");
    BOOST_TEST(contains(message_of<InputError>([&] { read_archive(folder.path()); }),
                        "archive.csv:1: not the header of an archive"));
}
