// SPDX-License-Identifier: MIT
#include "record/run_reader.h"

#include "base/error.h"
#include "core/record/fake_run.h"
#include "record/checkpoint.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

FakeLife life(int generation, int slot) { return {.fitness = 1.0 + generation + slot}; }

} // namespace

BOOST_AUTO_TEST_CASE(complete_runs_are_found_by_seed) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 2, 3);
    for (const std::uint64_t seed : {12, 3, 1000}) write_fake_run(folder.path(), spec, seed, life);
    make_folder(folder / "osc/seed-004");
    const auto runs = find_runs(folder.path(), "osc");
    BOOST_REQUIRE(runs.size() == 3u);
    BOOST_TEST(runs[0].seed == 3);
    BOOST_TEST(runs[1].seed == 12);
    BOOST_TEST(runs[2].seed == 1000);
    BOOST_TEST(runs[0].generations == 2);
    BOOST_TEST(runs[0].population == 3);
}

BOOST_AUTO_TEST_CASE(a_setting_without_a_folder_has_no_runs) {
    const TemporaryFolder folder;
    BOOST_TEST(find_runs(folder.path(), "grn").empty());
}

BOOST_AUTO_TEST_CASE(a_run_in_the_wrong_place_is_refused) {
    const TemporaryFolder folder;
    write_fake_run(folder.path(), fake_spec("osc", 2, 3), 1, life);
    std::filesystem::rename(folder / "osc/seed-001", folder / "osc/seed-002");
    BOOST_TEST(contains(message_of<InputError>([&] { find_runs(folder.path(), "osc"); }),
                        "seed-002/manifest.csv: it is of the run 'osc', seed 1, which does not belong here"));
}

BOOST_AUTO_TEST_CASE(an_untouched_run_is_verified) {
    const TemporaryFolder folder;
    write_fake_run(folder.path(), fake_spec("osc", 2, 3), 1, life, 0.5);
    BOOST_CHECK_NO_THROW(verify(find_runs(folder.path(), "osc").front()));
}

BOOST_AUTO_TEST_CASE(a_changed_byte_of_any_file_is_found_and_the_file_named) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 2, 3), 1, life, 0.5);
    const RecordedRun run = find_runs(folder.path(), "osc").front();
    for (const std::string file : {"experiment.lua", "resolved.lua", "generations.csv", "individuals.csv.gz",
                                   "champions.csv", "archive.csv", "best_genome.csv"}) {
        const std::string whole = read_bytes(place / file);
        std::string changed = whole;
        changed[changed.size() / 2] ^= 1;
        write_bytes(place / file, changed);
        BOOST_TEST(contains(message_of<InputError>([&] { verify(run); }), (place / file).string() + ": "),
                   file);
        write_bytes(place / file, whole);
    }
    std::filesystem::remove(place / "champions.csv");
    BOOST_TEST(contains(message_of<InputError>([&] { verify(run); }), "cannot open"));
}

BOOST_AUTO_TEST_CASE(a_changed_hash_in_the_manifest_is_found) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 2, 3), 1, life);
    std::string manifest = read_bytes(place / "manifest.csv");
    const std::size_t at = manifest.find("results_sha256,") + 15;
    manifest[at] = manifest[at] == '0' ? '1' : '0';
    write_bytes(place / "manifest.csv", manifest);
    BOOST_TEST(contains(message_of<InputError>([&] { verify(find_runs(folder.path(), "osc").front()); }),
                        "do not agree with results_sha256"));
}

BOOST_AUTO_TEST_CASE(a_damaged_best_genome_is_refused_with_its_file) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 2, 3), 1, life);
    const RecordedRun run = find_runs(folder.path(), "osc").front();
    BOOST_TEST(read_best_genome(run).inputs == input::count);
    std::string table = read_bytes(place / "best_genome.csv");
    table.replace(table.find("bias"), 4, "hidden");
    write_bytes(place / "best_genome.csv", table);
    BOOST_TEST(message_of<InputError>([&] {
                   read_best_genome(run);
               }).starts_with((place / "best_genome.csv").string() + ": genome "));
}

BOOST_AUTO_TEST_CASE(the_status_of_every_run_is_told) {
    const TemporaryFolder folder;
    write_fake_run(folder.path(), fake_spec("osc", 2, 3), 2, life);
    make_folder(folder / "osc/seed-001");
    make_folder(folder / "grn/seed-001");
    make_folder(folder / "grn/pictures");
    write_checkpoint(folder / "grn/seed-001", {.identity = "run", .generation = 3, .generations = 8});
    const auto runs = statuses(folder.path());
    BOOST_REQUIRE(runs.size() == 3u);
    BOOST_TEST(runs[0].folder == folder / "grn/seed-001");
    BOOST_TEST(!runs[0].is_complete);
    BOOST_TEST(runs[0].done == 3);
    BOOST_TEST(runs[0].generations == 8);
    BOOST_TEST(runs[1].generations == 0);
    BOOST_TEST(runs[2].is_complete);
    BOOST_TEST(runs[2].generations == 2);
    BOOST_CHECK_THROW(statuses(folder / "nowhere"), InputError);
}

BOOST_AUTO_TEST_CASE(a_single_run_is_read_only_when_it_is_complete) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 2, 3), 2, life);
    BOOST_TEST(read_run(place).setting == "osc");
    BOOST_TEST(read_run(place).seed == 2);
    std::filesystem::remove(place / "manifest.csv");
    BOOST_TEST(
        contains(message_of<InputError>([&] { read_run(place); }), "is not the folder of a complete run"));
}
