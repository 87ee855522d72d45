// SPDX-License-Identifier: MIT
// lineage and genome: the ancestors of an individual, and any individual of a run.
#include "support/commands.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <boost/test/unit_test.hpp>

#include <sys/stat.h>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

} // namespace

BOOST_AUTO_TEST_CASE(the_history_of_a_run_can_be_read_and_drawn) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const std::string run = place.run();
    const Said lineage = planula_says({"lineage", run, "--copies"});
    BOOST_TEST(lineage.code == 0, lineage.err);
    BOOST_TEST(lineage.out.starts_with("generation,slot,genome,origin,mother,father,"), lineage.out);
    BOOST_TEST(planula_says({"lineage", run, "--genome", "99"}).code == 65);
    BOOST_TEST(planula_says({"lineage", run, "--genome", "bset"}).code == 2);
    BOOST_TEST(planula_says({"lineage", place.runs(), "--copies"}).out == lineage.out); // the only run there
    BOOST_TEST(planula_says({"lineage", place.path / "small.lua"}).code == 65);

    const Said genome = planula_says({"genome", run});
    BOOST_TEST(genome.code == 0, genome.err);
    BOOST_TEST(contains(genome.out, "\ndivision inhibitor\n"), genome.out);
    BOOST_TEST(contains(planula_says({"genome", run, "--genome", "99"}).err, "is not a champion"));
    const std::string svg = place.path / "net.svg", dot = place.path / "net.dot";
    BOOST_TEST(planula_says({"genome", run, "--svg", svg, "--dot", dot}).code == 0);
    BOOST_TEST(content(svg).starts_with("<svg "));
    BOOST_TEST(content(dot).starts_with("digraph "));
    BOOST_TEST(planula_says({"genome", run, "--svg", "/nowhere/net.svg"}).code == 73);
}

BOOST_AUTO_TEST_CASE(only_a_file_is_replaced_by_a_picture) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const fs::path pipe = place.path / "pipe", folder = place.path / "folder";
    BOOST_REQUIRE(mkfifo(pipe.c_str(), 0600) == 0);
    fs::create_directory(folder);
    for (const char *option : {"--svg", "--dot", "--csv"})
        for (const fs::path &path : {fs::path("/dev/null"), pipe, folder}) {
            const auto kind = fs::status(path).type();
            const Said said = planula_says({"genome", place.run(), option, path});
            BOOST_TEST(said.code == 73, path);
            BOOST_TEST(contains(said.err, path.string() + " exists and is not a file; it is not replaced"),
                       said.err);
            BOOST_TEST((fs::status(path).type() == kind), path);
        }
}

BOOST_AUTO_TEST_CASE(every_individual_is_computed_again_as_it_was_recorded) {
    // Some are simulated from the beginning, some from a saved state.
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "28"}).code == 0);
    std::map<std::pair<int, int>, IndividualRow> rows;
    for (const IndividualRow &row : read_table<IndividualRow>(place.run()))
        rows[{row.generation, row.slot}] = row;
    BOOST_TEST(rows.size() == 28u * 6);
    for (const auto &[generation, slot] :
         std::vector<std::pair<int, int>>{{0, 0}, {0, 5}, {3, 2}, {24, 1}, {25, 0}, {26, 4}, {27, 5}}) {
        const IndividualRow &row = rows.at({generation, slot});
        const std::string table = place.path / "genome.csv",
                          at = std::to_string(generation) + "/" + std::to_string(slot);
        const std::vector<std::string> words{"genome",       place.run(),
                                             "--generation", std::to_string(generation),
                                             "--slot",       std::to_string(slot)};
        const Said said = planula_says(words);
        BOOST_TEST(said.code == 0, said.err);
        const std::string first = "small, seed 1, generation " + std::to_string(generation) + ", genome " +
                                  to_field(row.genome) + "\n" + row.outcome + ", " + to_field(row.cells) +
                                  " cells (" + to_field(row.births) + " created), moved ";
        BOOST_TEST(said.out.starts_with(first), said.out << first);
        BOOST_TEST(contains(said.out, " cells from (" + to_field(row.rest_x) + ", " + to_field(row.rest_y) +
                                          ") to (" + to_field(row.finish_x) + ", " + to_field(row.finish_y) +
                                          "), fitness " + to_field(row.fitness) + ", score " +
                                          to_field(row.score) + "\n"),
                   at << said.out);

        auto with_table = words;
        with_table.insert(with_table.end(), {"--csv", table});
        BOOST_TEST(planula_says(with_table).code == 0);
        std::vector<GenomeRow> genes;
        TableReader<GenomeRow> reader(table, header_of<GenomeRow>());
        for (GenomeRow gene; reader.next(gene);) genes.push_back(gene);
        const Genome genome = genome_of(genes);
        BOOST_TEST(genome.id == row.genome, at);
        BOOST_TEST(static_cast<int>(genome.links.size()) == row.links, at);
    }
    // So are those of a run that was recorded as a sample.
    test::write(place.script(), replaced(small, "name = 'small'", "name = 'small', record = 'sample'"));
    const std::string sample = place.path / "sample";
    BOOST_REQUIRE(
        planula_says({"run", place.script(), "--out", sample, "--seeds", "1", "--generations", "28"}).code ==
        0);
    const std::vector<std::string> last{"--generation", "27", "--slot", "5"};
    std::vector<std::string> full{"genome", place.run()}, part{"genome", sample + "/small/seed-001"};
    full.insert(full.end(), last.begin(), last.end()), part.insert(part.end(), last.begin(), last.end());
    BOOST_TEST(planula_says(full).out == planula_says(part).out);
}

BOOST_AUTO_TEST_CASE(generation_and_slot_must_be_those_of_an_individual_of_the_run) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1"}).code == 0);
    const auto refused = [&](std::vector<std::string> words, int code, const std::string &part) {
        words.insert(words.begin(), {"genome", place.run()});
        const Said said = planula_says(words);
        BOOST_TEST(said.code == code, part);
        BOOST_TEST(contains(said.err, part), said.err);
    };
    refused({"--generation", "2", "--slot", "0"}, 65, ": no generation 2; they are 0 to 1");
    refused({"--generation", "1", "--slot", "6"}, 65, ": no slot 6; they are 0 to 5");
    refused({"--generation", "1"}, 2, "--generation and --slot are given together");
    refused({"--slot", "1"}, 2, "--generation and --slot are given together");
    refused({"--slot", "-1", "--generation", "1"}, 2, "--slot takes a whole number of 0 or more");
    refused({"--slot", "1", "--generation", "1", "--genome", "3"}, 2, "give either --genome");
    // A run whose record was edited is not simulated.
    const fs::path file = place.run() / "generations.csv";
    test::write(file, replaced(content(file), "\n1,", "\n1,1"));
    refused({"--generation", "1", "--slot", "0"}, 65, file.string() + ": its content is not what");
}
