// SPDX-License-Identifier: MIT
#include "storage/journal.h"

#include "base/error.h"
#include "core/storage/temporary_folder.h"
#include "storage/input.h"
#include "storage/output.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using From = JournalStart::From;

BOOST_AUTO_TEST_CASE(a_journal_that_resumes_drops_the_rows_after_its_mark) {
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
            Journal journal(target, {From::journal, mark});
            journal.write("second\n");
            BOOST_TEST(journal.publish() == sha256("first\nsecond\n"));
        }
        write_file(folder / ("whole-" + name), "first\nsecond\n");
        BOOST_TEST((read_bytes(target) == read_bytes(folder / ("whole-" + name))));
    }
}

BOOST_AUTO_TEST_CASE(a_journal_without_a_mark_is_removed) {
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
        const std::string said = message_of<InputError>([&] {
            Journal resumed(folder / "table.csv", {From::journal, mark});
        });
        BOOST_TEST(contains(said, part.string() + ": "), said);
        BOOST_TEST(read_bytes(part) == bytes);
    }
}

BOOST_AUTO_TEST_CASE(a_full_disk_is_reported_with_the_name_of_the_journal) {
    const TemporaryFolder folder;
    const std::filesystem::path part = journal_path(folder / "table.csv");
    std::filesystem::create_symlink("/dev/full", part);
    Journal journal(folder / "table.csv");
    journal.write("short enough to wait in memory\n");
    BOOST_TEST(message_of<IoError>([&] { journal.mark(); }) ==
               "cannot write " + part.string() + ": No space left on device");
}

BOOST_AUTO_TEST_CASE(a_journal_that_begins_with_a_published_table_leaves_that_alone_until_it_is_published) {
    const TemporaryFolder folder;
    for (const std::string name : {"table.csv", "table.csv.gz"}) {
        const std::filesystem::path target = folder / name;
        const std::string head(200'000, 'h');
        JournalMark mark;
        {
            Journal journal(target);
            journal.write(head);
            mark = journal.mark();
            journal.write("last\n");
            journal.publish();
        }
        std::filesystem::remove(journal_path(target));
        const std::string published = read_bytes(target);
        {
            // One that ends before its first mark leaves nothing.
            Journal journal(target, {From::target, mark});
            journal.write("forgotten\n");
        }
        BOOST_TEST(!std::filesystem::exists(journal_path(target)));
        Journal journal(target, {From::target, mark});
        BOOST_TEST(!journal.is_empty());
        journal.write("second\n");
        BOOST_TEST(journal.mark().length == static_cast<std::int64_t>(head.size()) + 7);
        BOOST_TEST((read_bytes(target) == published));
        BOOST_TEST((read_bytes(journal_path(target)) == head + "second\n"));
        BOOST_TEST(journal.publish() == sha256(head + "second\n"));
        BOOST_TEST((read_file(target) == head + "second\n"));
    }
}

BOOST_AUTO_TEST_CASE(a_published_table_that_was_changed_or_cut_is_refused_by_name_and_leaves_no_journal) {
    const TemporaryFolder folder;
    for (const std::string name : {"table.csv", "table.csv.gz"}) {
        const std::filesystem::path target = folder / name;
        const JournalMark mark{13, sha256("first\nsecond\n")};
        for (const std::string text : {"first\nsecund\nthird\n", "first\n", ""}) {
            write_file(target, text);
            const std::string bytes = read_bytes(target);
            const std::string said = message_of<InputError>([&] { Journal(target, {From::target, mark}); });
            BOOST_TEST(contains(said, target.string() + ": "), said);
            BOOST_TEST((read_bytes(target) == bytes));
            BOOST_TEST(!std::filesystem::exists(journal_path(target)));
        }
        std::filesystem::remove(target);
        BOOST_TEST(contains(message_of<InputError>([&] {
                                Journal(target, {From::target, mark});
                            }),
                            "cannot open"));
        BOOST_TEST(!std::filesystem::exists(journal_path(target)));
    }
}

BOOST_AUTO_TEST_CASE(a_mark_says_how_a_file_begins) {
    const TemporaryFolder folder;
    write_file(folder / "file", "first\nsecond\n");
    check_mark(folder / "file", {0, sha256("")});
    check_mark(folder / "file", {6, sha256("first\n")});
    check_mark(folder / "file", {13, sha256("first\nsecond\n")});
    const auto refusal = [&](const JournalMark &mark) {
        return message_of<InputError>([&] { check_mark(folder / "file", mark); });
    };
    const std::string file = (folder / "file").string();
    BOOST_TEST(refusal({6, sha256("First\n")}) == file + ": it was changed after the run had stopped");
    BOOST_TEST(refusal({20, sha256("first\n")}) ==
               file + ": 13 bytes, where the kept state knows of 20: it was cut after the run had stopped");
}

BOOST_AUTO_TEST_CASE(a_journal_is_published_from_what_lies_on_disk) {
    const TemporaryFolder folder;
    Journal journal(folder / "table.csv");
    journal.write("first\nsecond\n");
    journal.mark();
    const auto refusal = [&](const std::string &bytes) {
        write_bytes(journal_path(folder / "table.csv"), bytes);
        return message_of<IoError>([&] { journal.publish(); });
    };
    BOOST_TEST(contains(refusal("first\n"), "it is shorter than what was written"));
    BOOST_TEST(contains(refusal("first\nsecund\n"), "does not read back as it was written"));
    BOOST_TEST(!std::filesystem::exists(folder / "table.csv"));
    BOOST_TEST(refusal("first\nsecond\n") == "");
}
