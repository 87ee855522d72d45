// SPDX-License-Identifier: MIT
#include "tables/genome_table.h"

#include "base/error.h"
#include "base/random.h"
#include "core/storage/temporary_folder.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace planula;

namespace {

/// Two inputs and a bias, one output, one hidden node, a recurrent link.
Genome specimen() {
    Genome genome{.id = 123456789012, .mother = 17, .father = -1, .origin = Origin::crossover_mutation};
    genome.inputs = 3, genome.outputs = 1;
    genome.nodes = {{0, NodeKind::input, 0},
                    {1, NodeKind::input, 0},
                    {2, NodeKind::bias, 0},
                    {3, NodeKind::output, 1},
                    {9, NodeKind::hidden, 1.0 / 3}};
    genome.links = {{0, 0, 3, 0.1, false},
                    {4, 2, 9, -1e-300, false},
                    {5, 9, 3, 7.999999999999999, false},
                    {8, 9, 9, -0.0, true}};
    check_genome(genome);
    return genome;
}

std::string refusal(const std::function<void(std::vector<GenomeRow> &)> &damage) {
    std::vector<GenomeRow> rows = genome_rows(specimen());
    damage(rows);
    return message_of<InputError>([&] { genome_of(rows); });
}

} // namespace

BOOST_AUTO_TEST_CASE(a_genome_comes_back_from_its_rows) {
    BOOST_TEST((genome_of(genome_rows(specimen())) == specimen()));
}

BOOST_AUTO_TEST_CASE(a_genome_comes_back_from_a_file_with_the_same_bits) {
    const TemporaryFolder folder;
    write_table<GenomeRow>(folder.path(), genome_rows(specimen()));
    const Genome back = genome_of(read_table<GenomeRow>(folder.path()));
    BOOST_TEST((back == specimen()));
    BOOST_TEST(std::signbit(back.links.back().weight));
}

BOOST_AUTO_TEST_CASE(every_origin_has_a_row_of_its_own) {
    for (const Origin origin : {Origin::initial, Origin::champion, Origin::filler, Origin::clone,
                                Origin::mutation, Origin::crossover, Origin::crossover_mutation}) {
        Genome genome = specimen();
        genome.origin = origin;
        BOOST_TEST((genome_of(genome_rows(genome)) == genome));
    }
}

BOOST_AUTO_TEST_CASE(hostile_rows_are_refused_with_the_rule) {
    BOOST_TEST(refusal([](auto &rows) { rows.clear(); }) == "a genome without rows");
    BOOST_TEST(refusal([](auto &rows) { rows.erase(rows.begin()); }) ==
               "genome row 'input' with id 0: a genome starts with its origin");
    BOOST_TEST(refusal([](auto &rows) { rows[1].kind = "inptu"; }) ==
               "genome row 'inptu' with id 0: neither a kind of node nor a link");
    BOOST_TEST(refusal([](auto &rows) { rows[6].from.reset(); }) ==
               "genome row 'link' with id 0: the column 'from' is empty");
    BOOST_TEST(refusal([](auto &rows) { rows[6].value.reset(); }) ==
               "genome row 'link' with id 0: the column 'value' is empty");
    BOOST_TEST(refusal([](auto &rows) { rows[6].to = std::int64_t{1} << 40; }) ==
               "genome row 'link' with id 0: 'to' = 1099511627776 is not a number of a node or link");
    BOOST_TEST(refusal([](auto &rows) { rows[6].recurrent = 2; }) ==
               "genome row 'link' with id 0: 'recurrent' is neither 0 nor 1");
    BOOST_TEST(refusal([](auto &rows) { std::swap(rows[5], rows[6]); }) ==
               "genome row 'hidden' with id 9: a node follows a link");
    BOOST_TEST(!refusal([](auto &rows) { rows[6].to = 77; }).empty());
    BOOST_TEST(!refusal([](auto &rows) { rows[7].id = 0; }).empty());
    BOOST_TEST(!refusal([](auto &rows) { rows[4].kind = "hidden"; }).empty());
}

BOOST_AUTO_TEST_CASE(a_damaged_table_is_a_sound_genome_or_an_error_and_nothing_else) {
    const TemporaryFolder folder;
    write_table<GenomeRow>(folder.path(), genome_rows(specimen()));
    const std::string whole = read_bytes(folder / "genome.csv");
    Stream stream(2, 0, 0, Purpose::sampling);
    int sound = 0, refused = 0;
    for (int i = 0; i < 3000; ++i) {
        // One to four bytes are changed, dropped or doubled.
        std::string bytes = whole;
        for (std::uint32_t edits = 1 + stream.below(4); edits > 0; --edits) {
            const std::size_t at = stream.below(static_cast<std::uint32_t>(bytes.size()));
            const std::uint32_t kind = stream.below(3);
            if (kind == 0) bytes[at] = static_cast<char>(stream.below(256));
            if (kind == 1) bytes.erase(at, 1);
            if (kind == 2) bytes.insert(at, 1, bytes[at]);
        }
        write_bytes(folder / "genome.csv", bytes);
        try {
            check_genome(genome_of(read_table<GenomeRow>(folder.path())));
            ++sound;
        } catch (const InputError &) {
            ++refused;
        }
    }
    BOOST_TEST(sound + refused == 3000);
    BOOST_TEST(refused > 1000);
}

BOOST_AUTO_TEST_CASE(genomes_of_champions_read_back_and_those_out_of_order_are_refused) {
    const TemporaryFolder folder;
    const auto write = [&](std::vector<int> generations) {
        std::vector<ChampionGenomeRow> rows;
        for (const int generation : generations)
            for (const auto &row : numbered_rows<ChampionGenomeRow>(generation, specimen()))
                rows.push_back(row);
        write_table<ChampionGenomeRow>(folder.path(), rows);
    };
    write({0, 4, 5});
    const auto champions = read_numbered<ChampionGenomeRow>(folder.path());
    BOOST_REQUIRE(champions.size() == 3u);
    BOOST_TEST(champions[1].number == 4);
    BOOST_TEST((champions[2].genome == specimen()));
    write({4, 3});
    BOOST_TEST(contains(message_of<InputError>([&] { read_numbered<ChampionGenomeRow>(folder.path()); }),
                        "this genome comes before the last one"));
    // A generation with two genomes: the second one's head is no gene of the first.
    write({4, 4});
    BOOST_TEST(contains(message_of<InputError>([&] { read_numbered<ChampionGenomeRow>(folder.path()); }),
                        "champion_genomes.csv.gz:"));
}
