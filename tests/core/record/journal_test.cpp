// SPDX-License-Identifier: MIT
#include "record/journal.h"

#include "base/error.h"
#include "core/record/fake_run.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(a_journal_taken_up_forgets_what_came_after_its_mark) {
    const TemporaryFolder folder;
    for (const std::string name : {"table.csv", "table.csv.gz"}) {
        const std::filesystem::path target = folder / name;
        JournalMark mark;
        {
            Journal journal(target);
            journal.write("first\n");
            mark = journal.mark();
            journal.write(std::string(100'000, 'x'));
        }
        {
            Journal journal(target, &mark);
            journal.write("second\n");
            BOOST_TEST(journal.publish() == sha256("first\nsecond\n"));
        }
        write_file(folder / ("whole-" + name), "first\nsecond\n");
        BOOST_TEST((read_bytes(target) == read_bytes(folder / ("whole-" + name))));
    }
}

BOOST_AUTO_TEST_CASE(a_journal_that_nothing_can_take_up_goes) {
    const TemporaryFolder folder;
    { Journal(folder / "table.csv").write("first\n"); }
    BOOST_TEST(!std::filesystem::exists(folder / "table.csv.part"));
}

BOOST_AUTO_TEST_CASE(a_journal_that_was_changed_or_cut_is_refused_by_name_and_left_alone) {
    const TemporaryFolder folder;
    const std::filesystem::path part = journal_path(folder / "table.csv");
    JournalMark mark;
    {
        Journal journal(folder / "table.csv");
        journal.write("first\nsecond\n");
        mark = journal.mark();
    }
    for (const std::string bytes : {"first\nsecund\nthird\n", "first\n", ""}) {
        write_bytes(part, bytes);
        const std::string said =
            message_of<InputError>([&] { Journal taken_up(folder / "table.csv", &mark); });
        BOOST_TEST(contains(said, part.string() + ": "), said);
        BOOST_TEST(read_bytes(part) == bytes);
    }
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_told_with_the_name_of_the_journal) {
    const TemporaryFolder folder;
    const std::filesystem::path part = journal_path(folder / "table.csv");
    std::filesystem::create_symlink("/dev/full", part);
    Journal journal(folder / "table.csv");
    journal.write("short enough to wait in memory\n");
    BOOST_TEST(message_of<IoError>([&] { journal.mark(); }) ==
               "cannot write " + part.string() + ": No space left on device");
}
