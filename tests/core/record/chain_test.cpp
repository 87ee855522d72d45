// SPDX-License-Identifier: MIT
#include "record/chain.h"

#include "base/error.h"
#include "base/hash.h"
#include "base/text.h"
#include "core/record/fake_run.h"
#include "storage/input.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>

using namespace planula;

namespace {

constexpr std::uint64_t seed = 5;
constexpr int generations = 4;

/// Fitness rises in every other generation.
FakeLife life(int generation, int slot) {
    return {.fitness = 10.0 + generation / 2 * 2 - slot,
            .moved = {1.0 + slot, 2},
            .cells = 20 + slot + generation};
}

/// A complete run whose tables may be changed, and are mended afterwards.
struct Recorded {
    Recorded()
        : place(write_fake_run(folder.path(), fake_spec("osc", generations, 3, "novelty"), seed, life)) {}

    void check() const { check_chain(place, identity, read_chain(place)); }
    /// What is said when a table has this text.
    std::string with(std::string_view table, const std::string &text) const {
        const std::string name(table), good = read_file(place / name);
        write_file(place / name, text);
        const std::string said = message_of<InputError>([&] { check(); });
        write_file(place / name, good);
        return said;
    }
    std::string text(std::string_view table) const { return read_file(place / std::string(table)); }

    TemporaryFolder folder;
    std::filesystem::path place;
    std::string identity = identity_of(fake_spec("osc", generations, 3, "novelty"), seed).sha256();
};

/// "DIR: generation 2 is not as the chain has it …".
std::string at(const Recorded &run, int generation) {
    return run.place.string() + ": generation " + to_text(generation) +
           " is not as the chain has it: a table or the chain was changed there";
}

/// The lines of a text, ended.
std::vector<std::string> lines_of(const std::string &text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = text.find('\n', begin) + 1;
        lines.push_back(text.substr(begin, end - begin));
        begin = end;
    }
    return lines;
}

std::string joined(const std::vector<std::string> &lines) {
    std::string text;
    for (const std::string &line : lines) text += line;
    return text;
}

} // namespace

BOOST_AUTO_TEST_CASE(an_unchanged_run_agrees_with_its_chain) {
    const Recorded run;
    const auto chain = read_chain(run.place);
    BOOST_REQUIRE(chain.size() == 4u);
    BOOST_CHECK_NO_THROW(run.check());
    for (const ChainRow &row : chain) {
        BOOST_TEST(row.content.size() == 64u);
        BOOST_TEST(row.link.size() == 64u);
    }
}

BOOST_AUTO_TEST_CASE(a_link_is_made_of_the_one_before_the_content_and_the_rows) {
    const Recorded run;
    FakeRun fake(fake_spec("osc", generations, 3, "novelty"), seed);
    const auto row_after = [&](const std::string &before, const RowTexts &rows) {
        ChainRow row;
        FakeRun again(fake_spec("osc", generations, 3, "novelty"), seed);
        again.observe(life, [&](const Generation &generation) { row = chain_row(before, generation, rows); });
        return row;
    };
    RowTexts rows;
    const ChainRow plain = row_after("before", rows);
    Hash expected;
    expected.text("before").text(plain.content);
    for (std::size_t i = 0; i < rows.size(); ++i) expected.text(sha256(""));
    BOOST_TEST(plain.link == expected.hex());
    BOOST_TEST(row_after("other", rows).link != plain.link);
    BOOST_TEST(row_after("other", rows).content == plain.content);
    for (std::string &text : rows) {
        text = "0,1\n";
        BOOST_TEST(row_after("before", rows).link != plain.link);
        text.clear();
    }
    fake.observe(
        [](int, int) { return FakeLife{.fitness = 3}; },
        [&](const Generation &generation) { BOOST_TEST(generation_sha256(generation) != plain.content); });
    BOOST_TEST(chain_start("one") != chain_start("two"));
}

BOOST_AUTO_TEST_CASE(a_changed_digit_in_any_table_names_its_generation) {
    const Recorded run;
    for (const std::string_view table : run_tables) {
        const std::vector<std::string> lines = lines_of(run.text(table));
        for (std::size_t i = 1; i < lines.size(); i += 1 + lines.size() / 20) {
            // Any digit but those of the generation's number.
            std::vector<std::string> changed = lines;
            const std::size_t digit = changed[i].find_first_of("0123456789", changed[i].find(','));
            if (digit == std::string::npos) continue;
            changed[i][digit] = changed[i][digit] == '7' ? '3' : '7';
            BOOST_TEST(run.with(table, joined(changed)) == at(run, lines[i][0] - '0'), table << ":" << i + 1);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_changed_link_or_content_names_its_generation) {
    const Recorded run;
    const std::vector<std::string> lines = lines_of(run.text("chain.csv"));
    for (int generation = 0; generation < generations; ++generation)
        for (const std::size_t digit : {2u, 60u, 70u, 120u}) {
            std::vector<std::string> changed = lines;
            char &hex = changed[static_cast<std::size_t>(generation) + 1][digit];
            hex = hex == 'a' ? 'b' : 'a';
            BOOST_TEST(run.with("chain.csv", joined(changed)) == at(run, generation));
        }
}

BOOST_AUTO_TEST_CASE(swapped_generations_are_named) {
    const Recorded run;
    for (const std::string_view table : {"generations.csv", "sizes.csv.gz", "individuals.csv.gz"}) {
        // The rows of generations 1 and 2 under each other's number.
        std::vector<std::string> lines = lines_of(run.text(table));
        std::vector<std::string> one, two, rest[2];
        for (const std::string &line : lines) {
            if (line.starts_with("1,"))
                one.push_back("2" + line.substr(1));
            else if (line.starts_with("2,"))
                two.push_back("1" + line.substr(1));
            else
                rest[one.empty() ? 0 : 1].push_back(line);
        }
        BOOST_TEST(run.with(table, joined(rest[0]) + joined(two) + joined(one) + joined(rest[1])) ==
                       at(run, 1),
                   table);
        // And as they were, in another order.
        std::rotate(lines.begin() + 1, lines.begin() + 2, lines.end());
        BOOST_TEST(run.with(table, joined(lines)) == at(run, 0), table);
    }
    std::vector<std::string> links = lines_of(run.text("chain.csv"));
    std::swap(links[2], links[3]);
    BOOST_TEST(
        contains(run.with("chain.csv", joined(links)), "chain.csv:3: generation 2 where 1 must follow"));
    links[2][0] = '1', links[3][0] = '2';
    BOOST_TEST(run.with("chain.csv", joined(links)) == at(run, 1));
}

BOOST_AUTO_TEST_CASE(a_row_that_is_missing_or_one_too_many_names_its_generation) {
    const Recorded run;
    for (const std::string_view table : run_tables) {
        const std::vector<std::string> lines = lines_of(run.text(table));
        for (const std::size_t line : {std::size_t{1}, lines.size() / 2, lines.size() - 1}) {
            std::vector<std::string> fewer = lines, more = lines;
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(line));
            more.insert(more.begin() + static_cast<std::ptrdiff_t>(line), lines[line]);
            const std::string expected = at(run, lines[line][0] - '0');
            BOOST_TEST(run.with(table, joined(fewer)) == expected, table << ":" << line + 1);
            BOOST_TEST(run.with(table, joined(more)) == expected, table << ":" << line + 1);
        }
    }
}

BOOST_AUTO_TEST_CASE(rows_after_the_last_generation_are_reported_with_their_file) {
    const Recorded run;
    for (const std::string_view table : run_tables) {
        const std::string said = run.with(table, run.text(table) + "4,1,1,1\n");
        BOOST_TEST(said == (run.place / table).string() + ": there are rows after those of generation 3");
    }
    const std::string chain = run.text("chain.csv");
    BOOST_TEST(contains(run.with("chain.csv", chain.substr(0, chain.rfind('\n', chain.size() - 2) + 1)),
                        "generations.csv: there are rows after those of generation 2"));
    BOOST_TEST(run.with("chain.csv", chain + "4,a,b\n") == at(run, 4));
}

BOOST_AUTO_TEST_CASE(the_chain_of_another_seed_differs_from_the_first_generation) {
    const Recorded run;
    const std::string other = identity_of(fake_spec("osc", generations, 3, "novelty"), seed + 1).sha256();
    BOOST_TEST(message_of<InputError>([&] { check_chain(run.place, other, read_chain(run.place)); }) ==
               at(run, 0));
}

BOOST_AUTO_TEST_CASE(a_table_that_is_not_there_or_cut_is_an_error) {
    const Recorded run;
    for (const std::string_view table : run_tables) {
        const auto file = run.place / table;
        const std::string bytes = read_bytes(file);
        std::filesystem::remove(file);
        BOOST_CHECK_THROW(run.check(), InputError);
        write_bytes(file, bytes.substr(0, bytes.size() / 2));
        BOOST_CHECK_THROW(run.check(), InputError);
        write_bytes(file, bytes);
    }
    BOOST_CHECK_NO_THROW(run.check());
}
