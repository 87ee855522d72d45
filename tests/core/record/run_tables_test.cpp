// SPDX-License-Identifier: MIT
#include "record/run_tables.h"

#include "base/error.h"
#include "core/record/fake_run.h"
#include "storage/input.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;

namespace {

constexpr std::uint64_t seed = 1;

FakeLife life(int generation, int slot) { return {.fitness = 1.0 + generation + slot, .cells = 10 + slot}; }

/// The rows of the first generation.
RowTexts rows_of(const Spec &spec, bool has_new_champion) {
    RowTexts rows;
    FakeRun run(spec, seed);
    run.observe(life, [&](const Generation &generation) {
        rows = row_texts(generation, spec, seed, has_new_champion);
    });
    return rows;
}

std::size_t place_of(std::string_view file) {
    return static_cast<std::size_t>(std::find(run_tables.begin(), run_tables.end(), file) -
                                    run_tables.begin());
}

std::string first_line(const std::string &text) { return text.substr(0, text.find('\n') + 1); }

} // namespace

BOOST_AUTO_TEST_CASE(every_row_of_a_generation_begins_with_its_number) {
    const RowTexts rows = rows_of(fake_spec("osc", 1, 4, "novelty"), true);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        BOOST_TEST(!rows[i].empty(), run_tables[i]);
        BOOST_TEST(rows[i].back() == '\n', run_tables[i]);
        for (std::size_t at = 0; at < rows[i].size(); at = rows[i].find('\n', at) + 1)
            BOOST_TEST(rows[i].substr(at, 2) == "0,", run_tables[i]);
    }
}

BOOST_AUTO_TEST_CASE(only_a_generation_with_a_new_champion_adds_one) {
    const Spec spec = fake_spec("osc", 1, 4, "novelty");
    const RowTexts champion = rows_of(spec, true), other = rows_of(spec, false);
    for (std::size_t i = 0; i < champion.size(); ++i) {
        const bool is_champions =
            i == place_of(ChampionRow::file_name) || i == place_of(ChampionGenomeRow::file_name);
        if (is_champions)
            BOOST_TEST(other[i].empty(), run_tables[i]);
        else
            BOOST_TEST((other[i] == champion[i]), run_tables[i]);
    }
}

BOOST_AUTO_TEST_CASE(every_table_is_published_under_its_header) {
    const TemporaryFolder folder;
    RunTables tables(folder.path(), true, [](std::string_view) { return JournalStart{}; });
    tables.write(rows_of(fake_spec("osc", 1, 4, "novelty"), true));
    tables.write_link("0,a,b\n");
    const auto hashes = tables.publish();
    BOOST_REQUIRE(hashes.size() == run_tables.size() + 1);
    for (std::size_t i = 0; i < run_tables.size(); ++i) BOOST_TEST(hashes[i].first == run_tables[i]);
    BOOST_TEST(hashes.back().first == "chain.csv");
    for (const auto &[file, hash] : hashes) BOOST_TEST(hash == content_sha256(folder / file), file);
    const auto header = [&](const char *file) { return first_line(read_file(folder / file)); };
    BOOST_TEST(header("generations.csv") == header_line<GenerationRow>());
    BOOST_TEST(header("sizes.csv.gz") == header_line<SizeRow>());
    BOOST_TEST(header("fitness_classes.csv.gz") == header_line<FitnessClassRow>());
    BOOST_TEST(header("individuals.csv.gz") == header_line<IndividualRow>());
    BOOST_TEST(header("species.csv.gz") == header_line<SpeciesRow>());
    BOOST_TEST(header("champions.csv") == header_line<ChampionRow>());
    BOOST_TEST(header("champion_genomes.csv.gz") == header_line<ChampionGenomeRow>());
    BOOST_TEST(header("archive.csv.gz") == "generation,genome,fitness,novelty_or_gain,x,y\n");
    BOOST_TEST(header("chain.csv") == header_line<ChainRow>());
}

BOOST_AUTO_TEST_CASE(objectives_that_are_stated_end_the_rows_of_individuals) {
    Spec spec = fake_spec("osc", 1, 4, "nsga2");
    const std::string bare = rows_of(spec, true)[place_of(IndividualRow::file_name)];
    spec.aims = {{{"work", Objective::Value::stated, {}}, {"fitness", Objective::Value::fitness, {}}}, {}};
    const RowTexts rows = rows_of(spec, true);
    // The generation of this test has none, as individuals that are not valid.
    BOOST_TEST(first_line(rows[place_of(IndividualRow::file_name)]) ==
               first_line(bare).substr(0, first_line(bare).size() - 1) + ",\n");
    const TemporaryFolder folder;
    RunTables tables(
        folder.path(), true, [](std::string_view) { return JournalStart{}; }, spec.aims);
    tables.write(rows);
    tables.publish();
    const std::string header = first_line(read_file(folder / "individuals.csv.gz"));
    BOOST_TEST(header.ends_with("hidden,objective_work\n"), header);
    TableReader<IndividualRow> reader(folder.path());
    IndividualRow row;
    BOOST_TEST(reader.next(row));
}

BOOST_AUTO_TEST_CASE(the_header_of_an_archive_is_that_of_its_first_entry) {
    for (const std::size_t length : {1u, 2u, 5u}) {
        const TemporaryFolder folder;
        RunTables tables(folder.path(), true, [](std::string_view) { return JournalStart{}; });
        RowTexts rows;
        tables.write(rows);
        for (int i = 0; i < 3; ++i) {
            rows[place_of(ArchiveRow::file_name)] =
                archive_line({i, i, std::vector<double>(length, 0.5), 1, 2});
            tables.write(rows);
        }
        tables.publish();
        BOOST_TEST(first_line(read_file(folder / "archive.csv.gz")) == archive_header(length));
        BOOST_TEST(read_archive(folder.path()).size() == 3u);
    }
}

BOOST_AUTO_TEST_CASE(without_an_archive_there_is_no_table_of_one) {
    const TemporaryFolder folder;
    RunTables tables(folder.path(), false, [](std::string_view) { return JournalStart{}; });
    tables.write(rows_of(fake_spec("osc", 1, 4), true));
    BOOST_TEST(tables.marks().size() == run_tables.size());
    tables.publish();
    BOOST_TEST(!std::filesystem::exists(folder / "archive.csv.gz"));
    BOOST_TEST(std::filesystem::exists(folder / "chain.csv"));
}

BOOST_AUTO_TEST_CASE(tables_that_begin_at_their_marks_go_on_from_there) {
    using From = JournalStart::From;
    const Spec spec = fake_spec("osc", 1, 4, "novelty");
    const RowTexts rows = rows_of(spec, true);
    for (const From from : {From::journal, From::target}) {
        const TemporaryFolder folder;
        std::map<std::string, JournalMark> marks;
        {
            RunTables tables(folder.path(), true, [](std::string_view) { return JournalStart{}; });
            tables.write(rows);
            for (const auto &[file, mark] : tables.marks()) marks[file] = mark;
            if (from == From::target) tables.publish();
            tables.write(rows); // and is forgotten
            tables.marks();
        }
        RunTables tables(folder.path(), true, [&](std::string_view file) {
            return JournalStart{from, marks.at(std::string(file))};
        });
        tables.write(rows);
        tables.publish();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string text = read_file(folder / std::string(run_tables[i]));
            BOOST_TEST((text == first_line(text) + rows[i] + rows[i]), run_tables[i]);
        }
    }
}
