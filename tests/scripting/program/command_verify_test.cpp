// SPDX-License-Identifier: MIT
#include "record/chain.h"
#include "record/kept_state.h"
#include "record/run_reader.h"
#include "storage/input.h"
#include "support/commands.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::test;

namespace {

namespace fs = std::filesystem;

/// What verify says of a damaged folder; it must end with 65.
std::string found_in(const fs::path &folder, std::vector<std::string> words = {"--share", "0"}) {
    words.insert(words.begin(), {"verify", folder, "--threads", "1"});
    const Said said = planula_says(words);
    BOOST_TEST(said.code == 65, said.out);
    BOOST_TEST(contains(said.err, "1 run differs from its record"), said.err);
    return said.out;
}

} // namespace

BOOST_AUTO_TEST_CASE(unaltered_runs_are_verified_as_far_as_is_asked) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2", "--generations", "28"}).code == 0);
    const auto before = all_files(place.runs());
    const Said all = planula_says({"verify", place.runs(), "--share", "100", "--draw", "7"});
    BOOST_TEST(all.code == 0, all.out + all.err);
    BOOST_TEST(
        contains(all.out,
                 "verify: 2 runs of 56 generations in all: their files agree; 56 generations simulated again "
                 "as recorded (100.0 %, --draw 7).\n"
                 "The probability that one altered generation with consistent hashes was not found is "
                 "0.000.\n"),
        all.out);
    const Said none = planula_says({"verify", place.runs(), "--share", "0"});
    BOOST_TEST(none.code == 0);
    BOOST_TEST(contains(none.out, "; 0 generations simulated again as recorded (0.0 %"), none.out);
    BOOST_TEST(contains(none.out, "not found is 1.000."), none.out);
    BOOST_TEST(none.err == "");
    // One percent of a run is at least one stretch, and the same draw gives the same stretch.
    const Said one = planula_says({"verify", place.run(), "--draw", "3"});
    BOOST_TEST(one.code == 0, one.out);
    BOOST_TEST(contains(one.out, "verify: 1 run of 28 generations in all"), one.out);
    BOOST_TEST(planula_says({"verify", place.run(), "--draw", "3"}).err == one.err);
    for (const char *share : {"-1", "101", "x", "nan"})
        BOOST_TEST(planula_says({"verify", place.run(), "--share", share}).code == 2, share);
    BOOST_TEST((all_files(place.runs()) == before));
}

BOOST_AUTO_TEST_CASE(a_changed_table_is_found_with_its_generation_without_simulation) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "4"}).code == 0);
    const fs::path file = place.run() / "generations.csv";
    const std::string text = content(file);
    test::write(file, replaced(text, "\n2,", "\n2,1"));
    const std::string digit = found_in(place.runs());
    BOOST_TEST(contains(digit, place.run().string() + ": generation 2 is not as the chain has it"), digit);
    BOOST_TEST(contains(digit, file.string() + ": its content is not what the run's manifest says"), digit);
    test::write(file, text + content(file).substr(content(file).rfind("\n3,") + 1));
    BOOST_TEST(contains(found_in(place.runs()), "generation 3 is not as the chain has it"));
    test::write(file, text.substr(0, text.rfind("\n3,") + 1));
    BOOST_TEST(contains(found_in(place.runs()), "generation 3 is not as the chain has it"));
    fs::remove(file);
    BOOST_TEST(contains(found_in(place.runs()), "generations.csv"));
}

BOOST_AUTO_TEST_CASE(a_consistently_forged_record_is_found_by_simulation) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "4"}).code == 0);
    // The number of species of generation 2 is raised, and every hash over it is computed again.
    const std::string identity = open_run(place.run()).identity.sha256();
    const std::vector<ChainRow> chain = read_chain(place.run());
    std::vector<GenerationRow> rows = read_table<GenerationRow>(place.run());
    rows[2].species += 1;
    const std::string generations = write_table<GenerationRow>(place.run(), rows);
    std::string before = chain_start(identity), links = header_line<ChainRow>();
    for (const ChainRow &row : chain) {
        Hash link;
        link.text(before).text(row.content);
        for (const std::string_view table : run_tables) {
            std::string lines;
            const std::string start = std::to_string(row.generation) + ",";
            std::istringstream text(fs::exists(place.run() / table) ? read_file(place.run() / table) : "");
            for (std::string line; std::getline(text, line);)
                if (line.starts_with(start)) lines += line + '\n';
            link.text(sha256(lines));
        }
        before = link.hex();
        links += line_of(ChainRow{row.generation, row.content, before});
    }
    const std::string chain_sha256 = write_file(place.run() / "chain.csv", links);
    const Manifest old(place.run());
    Manifest manifest;
    for (const ManifestRow &row : old.rows())
        if (row.key != "manifest_sha256" && !row.key.starts_with("states/"))
            manifest.add(row.key, row.key == "generations.csv" ? generations
                                  : row.key == "chain.csv"     ? chain_sha256
                                  : row.key == "link"          ? before
                                                               : row.value);
    manifest.seal();
    manifest.write(place.run());
    fs::remove_all(place.run() / "states");

    const Said files = planula_says({"verify", place.runs(), "--share", "0"});
    BOOST_TEST(files.code == 0, files.out);
    const std::string found = found_in(place.runs(), {"--share", "100"});
    BOOST_TEST(contains(found, place.run().string() +
                                   ": generation 2 is not what simulating it again gives: its rows differ"),
               found);
}

BOOST_AUTO_TEST_CASE(changed_scripts_and_states_are_found) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "28"}).code == 0);
    const auto whole = all_files(place.run());
    for (const auto &[name, bytes] : whole) {
        std::string changed = bytes;
        changed.at(changed.size() / 2) ^= 1;
        test::write(place.run() / name, changed);
        const std::string found = found_in(place.runs());
        BOOST_TEST(contains(found, place.run().string()), name << ": " << found);
        test::write(place.run() / name, bytes);
    }
    BOOST_TEST(planula_says({"verify", place.runs(), "--share", "0"}).code == 0);
    // Two states that are exchanged.
    fs::copy_file(place.run() / "states/000025.state", place.run() / "states/000027.state",
                  fs::copy_options::overwrite_existing);
    BOOST_TEST(contains(found_in(place.runs()), "states/000027.state: "));
}

BOOST_AUTO_TEST_CASE(a_stretch_that_differs_is_not_counted_as_simulated) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "28"}).code == 0);
    // A state that is whole and has the right name, link and identity, and other genomes than the run had.
    const fs::path file = state_path(place.run(), 25);
    KeptState kept = read_state(file).value();
    kept.best_fitness += 1;
    const std::string sha256 = keep_state(place.run(), kept);
    const Manifest old(place.run());
    Manifest manifest;
    for (const ManifestRow &row : old.rows())
        if (row.key != "manifest_sha256")
            manifest.add(row.key, row.key == "states/000025.state" ? sha256 : row.value);
    manifest.seal();
    manifest.write(place.run());
    const std::string found = found_in(place.runs(), {"--share", "100"});
    BOOST_TEST(contains(found, file.string() + ": the kept state is not what simulating up to it gives"),
               found);
    BOOST_TEST(contains(found, "; 3 generations simulated again as recorded (10.7 %"), found);
    BOOST_TEST(contains(found, "not found is 0.893."), found);
}

BOOST_AUTO_TEST_CASE(a_run_may_lack_its_kept_states_before_the_last_and_verify_says_so) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1", "--generations", "28"}).code == 0);
    BOOST_TEST(!contains(planula_says({"verify", place.runs(), "--share", "0"}).out, "removed"));
    fs::remove(state_path(place.run(), 25));
    const Said said = planula_says({"verify", place.runs(), "--share", "100"});
    BOOST_TEST(said.code == 0, said.out);
    BOOST_TEST(contains(said.out, "28 generations simulated again as recorded (100.0 %"), said.out);
    BOOST_TEST(contains(said.out, "Kept states that were removed: 1."), said.out);
    fs::remove(state_path(place.run(), 27));
    BOOST_TEST(contains(found_in(place.runs()), place.run().string() + " lacks states/000027.state"));
}

BOOST_AUTO_TEST_CASE(verify_reports_folders_without_a_complete_run) {
    const Workplace place;
    BOOST_REQUIRE(place.run_says({"--seeds", "1:2"}).code == 0);
    fs::create_directories(place.run(3));
    fs::remove(place.run(2) / "manifest.csv");
    const Said said = planula_says({"verify", place.runs(), "--share", "0"});
    BOOST_TEST(said.code == 0, said.out);
    BOOST_TEST(said.err == place.run(2).string() + ": not complete, not checked\n");
    BOOST_TEST(contains(said.out, "Not complete and not checked: 1 run."), said.out);
    test::write(place.run(3) / "manifest.csv", "key,value\n");
    BOOST_TEST(
        contains(found_in(place.runs()),
                 place.run(3).string() + " is not the folder of a complete run: it has no identity.csv"));
    fs::remove_all(place.run(1)), fs::remove_all(place.run(3));
    const Said none = planula_says({"verify", place.runs()});
    BOOST_TEST(none.code == 65);
    BOOST_TEST(contains(none.err, place.runs() + ": there is no complete run"), none.err);
}
