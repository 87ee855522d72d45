// SPDX-License-Identifier: MIT
#include "tables/archive_table.h"

#include "base/error.h"
#include "core/storage/temporary_folder.h"
#include "storage/output.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

std::vector<ArchiveEntry> entries(std::size_t length) {
    std::vector<ArchiveEntry> list;
    for (int i = 0; i < 5; ++i)
        list.push_back({i / 2, 100 + i, std::vector<double>(length, i / 3.0), 0.5 + i / 7.0, i / 9.0});
    return list;
}

void write(const std::filesystem::path &path, std::size_t length) {
    std::string text = archive_header(length);
    for (const ArchiveEntry &entry : entries(length)) text += archive_line(entry);
    write_file(path, text);
}

} // namespace

BOOST_AUTO_TEST_CASE(archives_with_descriptors_of_any_length_read_back_equal) {
    for (const std::size_t length : {0, 1, 2, 3, 5}) {
        const TemporaryFolder folder;
        write(folder / "archive.csv.gz", length);
        write(folder / "archive.csv.gz.part", length);
        BOOST_TEST((read_archive(folder.path()) == entries(length)));
        BOOST_TEST((read_archive_journal(folder.path(), SIZE_MAX) == entries(length)));
    }
}

BOOST_AUTO_TEST_CASE(no_more_entries_are_read_than_asked_for) {
    const TemporaryFolder folder;
    write(folder / "archive.csv.gz", 2);
    const auto all = entries(2);
    for (std::size_t most = 0; most <= all.size(); ++most)
        BOOST_TEST((read_archive(folder.path(), most) == std::vector(all.begin(), all.begin() + most)));
    BOOST_TEST(read_archive(folder / "without_an_archive", 0).empty());
    BOOST_TEST(read_archive_journal(folder / "without_an_archive", 0).empty());
}

BOOST_AUTO_TEST_CASE(two_numbers_are_x_and_y_and_others_are_counted) {
    BOOST_TEST(archive_header(2) == "generation,genome,fitness,novelty_or_gain,x,y\n");
    BOOST_TEST(archive_header() == archive_header(2));
    BOOST_TEST(archive_header(1) == "generation,genome,fitness,novelty_or_gain,behaviour_1\n");
    BOOST_TEST(archive_header(3) ==
               "generation,genome,fitness,novelty_or_gain,behaviour_1,behaviour_2,behaviour_3\n");
    BOOST_TEST(archive_line({3, 4, {0.5, 6}, 7, 8}) == "3,4,8,7,0.5,6\n");
}

BOOST_AUTO_TEST_CASE(names_and_objectives_are_columns_and_read_back) {
    using enum Objective::Value;
    const Aims aims{{{"work", stated, {}}, {"fitness", fitness, {}}, {"far", stated, {}}},
                    {{"size"}, {"turn"}, {"x2"}}};
    const std::string header = "generation,genome,fitness,novelty_or_gain,behaviour_size,behaviour_turn,"
                               "behaviour_x2,objective_work,objective_far\n";
    BOOST_TEST(archive_header(2, aims) == header);
    const ArchiveEntry entry{3, 4, {0.5, 6, 9}, 7, 8, {-1, 2}};
    BOOST_TEST(archive_line(entry) == "3,4,8,7,0.5,6,9,-1,2\n");
    const TemporaryFolder folder;
    write_file(folder / "archive.csv.gz", header + archive_line(entry));
    BOOST_TEST((read_archive(folder.path()) == std::vector{entry}));
    const ArchiveEntry unnamed{3, 4, {0.5, 6}, 7, 8, {-1, 2}};
    write_file(folder / "archive.csv.gz", archive_header(2, {aims.objectives, {}}) + archive_line(unnamed));
    BOOST_TEST((read_archive(folder.path()) == std::vector{unnamed}));
}

BOOST_AUTO_TEST_CASE(a_foreign_header_is_refused) {
    const TemporaryFolder folder;
    for (const char *header :
         {"generation,genome,fitness,novelty_or_gain,x,z\n", "generation,genome,novelty,x,y\n",
          "generation,genome,fitness,novelty_or_gain,behaviour_2\n"}) {
        write_file(folder / "archive.csv.gz", header);
        BOOST_TEST(contains(message_of<InputError>([&] { read_archive(folder.path()); }),
                            "archive.csv.gz:1: not the header of an archive"));
    }
}
