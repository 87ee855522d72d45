// SPDX-License-Identifier: MIT
#include "record/merge.h"

#include "base/error.h"
#include "base/text.h"
#include "core/record/quick_run.h"
#include "record/chain.h"
#include "record/kept_state.h"
#include "storage/input.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
namespace fs = std::filesystem;

namespace {

/// What a merge that is refused says; neither folder may change.
template <class Kind> std::string refusal(const fs::path &from, const fs::path &into) {
    const auto source = contents(from), target = contents(into);
    const std::string said = message_of<Kind>([&] { merge_run(from, into); });
    BOOST_TEST((contents(from) == source), said);
    BOOST_TEST((contents(into) == target), said);
    return said;
}

void duplicate(const fs::path &from, const fs::path &to) {
    make_folder(to.parent_path());
    fs::copy(from, to, fs::copy_options::recursive);
}

/// The runs below a folder of parts: <folder>/<part>/quick/seed-006.
fs::path run_in(const TemporaryFolder &folder, const std::string &part) {
    return folder / part / fs::path("quick/seed-006");
}

/// Changes a run consistently from a generation on: another digit in its row of generations.csv, and new links.
void forge(const fs::path &folder, int from) {
    std::string table = read_bytes(folder / "generations.csv");
    const std::size_t row = table.find("\n" + to_text(from) + ","), digit = table.find(',', row) + 1;
    table[digit] = table[digit] == '7' ? '3' : '7';
    write_bytes(folder / "generations.csv", table);
    std::vector<ChainRow> chain = read_chain(folder);
    for (std::size_t i = static_cast<std::size_t>(from); i < chain.size(); ++i)
        chain[i].link = sha256(chain[i].link + (i > 0 ? chain[i - 1].link : ""));
    write_table<ChainRow>(folder, chain);
    Manifest forged;
    const Manifest manifest(folder);
    for (const ManifestRow &row_of : manifest.rows()) {
        if (row_of.key == "manifest_sha256") continue;
        forged.add(row_of.key, row_of.key == "link"  ? chain.back().link
                               : is_file(row_of.key) ? content_sha256(folder / row_of.key)
                                                     : row_of.value);
    }
    forged.seal();
    forged.write(folder);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_run_that_is_not_there_yet_is_copied_whole) {
    for (const bool complete : {true, false}) {
        const TemporaryFolder folder;
        const auto from = run_in(folder, "a"), into = run_in(folder, "all");
        quick::run_on(from, quick::spec(), complete ? -1 : 3 * quick::population);
        write_bytes(from / "generations.csv.tmp", "left by a process that was killed");
        auto source = contents(from);
        BOOST_TEST((merge_run(from, into) == Merged::copied));
        BOOST_TEST((contents(from) == source));
        source.erase("generations.csv.tmp");
        BOOST_TEST((contents(into) == source));
        BOOST_TEST((merge_run(from, into) == Merged::known));
        BOOST_TEST((contents(into) == source));
    }
}

BOOST_AUTO_TEST_CASE(a_merge_keeps_the_longer_of_two_lengths_of_a_run) {
    const TemporaryFolder folder;
    const auto shorter = run_in(folder, "a"), longer = run_in(folder, "b"), into = run_in(folder, "all");
    quick::write(shorter, quick::spec("novelty", 3));
    quick::write(longer, quick::spec("novelty", 5));
    BOOST_TEST((merge_run(shorter, into) == Merged::copied));
    BOOST_TEST((merge_run(longer, into) == Merged::longer));
    BOOST_TEST((contents(into) == contents(longer)));
    BOOST_TEST((merge_run(shorter, into) == Merged::known));
    BOOST_TEST((contents(into) == contents(longer)));
    // Nothing is left beside.
    BOOST_TEST(std::distance(fs::directory_iterator(into.parent_path()), fs::directory_iterator()) == 1);
}

BOOST_AUTO_TEST_CASE(a_run_under_way_is_as_long_as_its_newest_checkpoint) {
    const TemporaryFolder folder;
    const auto ahead = run_in(folder, "b"), behind = run_in(folder, "c"), into = run_in(folder, "all");
    quick::run_on(ahead, quick::spec("novelty", 7), 5 * quick::population);
    quick::run_on(behind, quick::spec("novelty", 7), 2 * quick::population);
    BOOST_TEST((merge_run(behind, into) == Merged::copied));
    BOOST_TEST((merge_run(ahead, into) == Merged::longer));
    BOOST_TEST((contents(into) == contents(ahead)));
    BOOST_TEST((merge_run(behind, into) == Merged::known));
    BOOST_TEST(quick::run_on(into, quick::spec("novelty", 7)));
    quick::write(folder / "at_once", quick::spec("novelty", 7));
    BOOST_TEST((contents(into) == contents(folder / "at_once")));
}

BOOST_AUTO_TEST_CASE(complete_results_are_replaced_by_complete_ones_alone) {
    // Complete at 3 and on the way to 9, beside one that is complete at 5.
    const TemporaryFolder folder;
    const auto longer = run_in(folder, "a"), complete = run_in(folder, "b"), into = run_in(folder, "all");
    quick::write(longer, quick::spec("novelty", 3));
    BOOST_TEST((merge_run(longer, into) == Merged::copied));
    quick::run_on(longer, quick::spec("novelty", 9), 4 * quick::population);
    BOOST_TEST((merge_run(longer, into) == Merged::longer));
    quick::write(complete, quick::spec("novelty", 5));
    const auto other = run_in(folder, "other");
    BOOST_TEST((merge_run(complete, other) == Merged::copied));
    BOOST_TEST((merge_run(longer, other) == Merged::unfinished));
    BOOST_TEST((contents(other) == contents(complete)));
    BOOST_TEST(quick::run_on(longer, quick::spec("novelty", 9)));
    BOOST_TEST((merge_run(longer, other) == Merged::longer));
    BOOST_TEST((merge_run(complete, other) == Merged::known));
}

BOOST_AUTO_TEST_CASE(runs_that_differ_are_refused_with_the_generation) {
    const TemporaryFolder folder;
    const auto one = run_in(folder, "a"), two = run_in(folder, "b");
    for (const int generation : {0, 2}) {
        quick::write(one, quick::spec("novelty", 5));
        quick::write(two, quick::spec("novelty", 3));
        forge(two, generation);
        for (const auto &[from, into] : {std::pair{one, two}, {two, one}})
            BOOST_TEST(refusal<InputError>(from, into) ==
                       from.string() + " and " + into.string() +
                           " contradict each other: their chains differ from generation " +
                           to_text(generation) + ". Nothing was changed.");
        fs::remove_all(one), fs::remove_all(two);
    }
}

BOOST_AUTO_TEST_CASE(another_run_in_the_place_is_refused_with_what_differs) {
    const TemporaryFolder folder;
    Spec other = quick::spec();
    other.parameters.neat.add_node_rate = 0.5;
    const auto one = run_in(folder, "a"), two = run_in(folder, "b"), three = run_in(folder, "c");
    quick::write(one, quick::spec());
    quick::write(two, other);
    BOOST_TEST(contains(refusal<InputError>(one, two),
                        "they are different runs, parameter add_node_rate: recorded "
                        "with 0.5, asked for with "));
    Spec sample = quick::spec();
    sample.record = sample_record;
    quick::write(three, sample);
    BOOST_TEST(
        contains(refusal<InputError>(one, three), "one is recorded as \"full\", the other as \"sample\""));
    BOOST_TEST(
        contains(refusal<InputError>(three, one), "one is recorded as \"sample\", the other as \"full\""));
}

BOOST_AUTO_TEST_CASE(something_else_in_the_place_is_refused) {
    const TemporaryFolder folder;
    const auto from = run_in(folder, "a"), into = run_in(folder, "all");
    quick::write(from, quick::spec());
    make_folder(into);
    write_bytes(into / "notes.txt", "of somebody else");
    BOOST_TEST(contains(refusal<CreateError>(from, into), "holds notes.txt and no identity.csv"));
    BOOST_TEST(contains(refusal<CreateError>(into, from), "holds notes.txt and no identity.csv"));
}

BOOST_AUTO_TEST_CASE(a_damaged_source_is_refused_and_the_target_stays) {
    const TemporaryFolder folder;
    const auto from = run_in(folder, "a"), into = run_in(folder, "all"), nowhere = run_in(folder, "none");
    quick::write(into, quick::spec("novelty", 3));
    quick::write(from, quick::spec("novelty", 5));
    for (const auto &[file, whole] : contents(from)) {
        std::string changed = whole;
        changed[changed.size() / 2] ^= 1;
        write_bytes(from / file, changed);
        BOOST_TEST(contains(refusal<InputError>(from, into), file), file);
        BOOST_CHECK_THROW(merge_run(from, nowhere), InputError);
        BOOST_TEST(!fs::exists(nowhere));
        write_bytes(from / file, whole);
    }
    // The same, under way: the tables of its newest checkpoint must be there.
    quick::run_on(from, quick::spec("novelty", 9), 3 * quick::population);
    for (const char *file : {"generations.csv.part", "archive.csv.gz.part", "chain.csv.part"}) {
        const std::string whole = read_bytes(from / file);
        std::string changed = whole;
        changed[changed.size() / 2] ^= 1;
        write_bytes(from / file, changed);
        BOOST_TEST(contains(refusal<InputError>(from, into), file), file);
        write_bytes(from / file, whole);
    }
    BOOST_TEST((merge_run(from, into) == Merged::longer));
}

BOOST_AUTO_TEST_CASE(a_damaged_target_is_refused_too) {
    const TemporaryFolder folder;
    const auto from = run_in(folder, "a"), into = run_in(folder, "all");
    quick::write(into, quick::spec("novelty", 3));
    quick::write(from, quick::spec("novelty", 5));
    write_bytes(into / "generations.csv", read_bytes(into / "generations.csv") + "x");
    BOOST_TEST(contains(refusal<InputError>(from, into), (into / "generations.csv").string()));
}

BOOST_AUTO_TEST_CASE(a_run_that_is_in_use_on_either_side_is_refused) {
    const TemporaryFolder folder;
    const auto from = run_in(folder, "a"), into = run_in(folder, "all");
    quick::write(into, quick::spec("novelty", 3));
    quick::write(from, quick::spec("novelty", 5));
    for (const auto &held : {from, into}) {
        const FolderLock lock(held);
        BOOST_TEST(refusal<CreateError>(from, into) == held.string() + " is in use by another process");
    }
    BOOST_TEST((merge_run(from, into) == Merged::longer));
}

BOOST_AUTO_TEST_CASE(folders_without_a_run_give_nothing_to_merge) {
    const TemporaryFolder folder;
    const auto from = run_in(folder, "a"), into = run_in(folder, "all");
    make_folder(from);
    BOOST_TEST((merge_run(from, into) == Merged::known));
    BOOST_TEST(!fs::exists(into));
    quick::write(from, quick::spec());
    make_folder(into); // of a process that was killed before it named its run
    BOOST_TEST((merge_run(from, into) == Merged::copied));
    BOOST_TEST((contents(into) == contents(from)));
}

BOOST_AUTO_TEST_CASE(a_killed_merge_loses_nothing_and_continues) {
    const TemporaryFolder folder;
    const auto shorter = run_in(folder, "a"), longer = run_in(folder, "b"), into = run_in(folder, "all");
    quick::write(shorter, quick::spec("novelty", 3));
    quick::write(longer, quick::spec("novelty", 5));
    const fs::path incoming = into.parent_path() / "seed-006.incoming",
                   old = into.parent_path() / "seed-006.replaced";
    const auto ends_well = [&](const fs::path &present) {
        end_merges(into.parent_path());
        BOOST_TEST((contents(into) == contents(present)));
        merge_run(longer, into);
        BOOST_TEST((contents(into) == contents(longer)));
        BOOST_TEST(std::distance(fs::directory_iterator(into.parent_path()), fs::directory_iterator()) == 1);
        fs::remove_all(into.parent_path());
    };
    // While it copied.
    duplicate(shorter, into);
    duplicate(longer, incoming);
    fs::remove(incoming / "manifest.csv");
    ends_well(shorter);
    // Between the two renames of a file system that cannot exchange.
    duplicate(shorter, old);
    duplicate(longer, incoming);
    ends_well(shorter);
    // After them.
    duplicate(longer, into);
    duplicate(shorter, old);
    ends_well(longer);
    // After an exchange.
    duplicate(longer, into);
    duplicate(shorter, incoming);
    ends_well(longer);
    // A merge by itself is not misled by what was left of a copy.
    duplicate(shorter, into);
    make_folder(incoming);
    write_bytes(incoming / "stray", "half a copy");
    BOOST_TEST((merge_run(longer, into) == Merged::longer));
    BOOST_TEST((contents(into) == contents(longer)));
    BOOST_CHECK_NO_THROW(end_merges(folder / "nowhere"));
}
