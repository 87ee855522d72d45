// SPDX-License-Identifier: MIT
#include "record/complete_run.h"

#include "base/error.h"
#include "core/record/fake_run.h"
#include "core/record/quick_run.h"
#include "record/chain.h"
#include "record/run_reader.h"
#include "storage/input.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

constexpr std::uint64_t seed = 5;

FakeLife life(int generation, int slot) { return {.fitness = 1.0 + generation + slot, .cells = 20 + slot}; }

/// A full disk for one file of a run.
void fill_disk_of(const std::filesystem::path &file) {
    make_folder(file.parent_path());
    std::filesystem::create_symlink("/dev/full", file);
}

/// A complete run of 3 generations, and the journals and checkpoint of a process that was killed after its manifest.
std::filesystem::path write_with_leftovers(const TemporaryFolder &folder) {
    const std::filesystem::path place = folder / "run", other = folder / "other";
    quick::run_on(place, quick::spec("novelty", 3), 2 * quick::population);
    quick::write(other, quick::spec("novelty", 3));
    std::filesystem::copy(other, place,
                          std::filesystem::copy_options::recursive |
                              std::filesystem::copy_options::overwrite_existing);
    BOOST_TEST(has_journals(place));
    return place;
}

} // namespace

BOOST_AUTO_TEST_CASE(the_manifest_has_the_hash_of_every_file_and_the_last_link) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4, "novelty"), seed, life);
    const Manifest manifest(place);
    manifest.check_seal();
    std::size_t files = 0;
    for (const ManifestRow &row : manifest.rows())
        if (is_file(row.key)) {
            ++files;
            BOOST_TEST(row.value == content_sha256(place / row.key), row.key);
        }
    BOOST_TEST(files == contents(place).size() - 1);
    BOOST_TEST(manifest.text("link") == read_chain(place).back().link);
    BOOST_TEST(manifest.text("record") == "full");
    BOOST_TEST(manifest.number("seed") == 5);
    BOOST_TEST(manifest.number("evaluations") == 12);
}

BOOST_AUTO_TEST_CASE(a_full_disk_ends_the_run_without_a_manifest) {
    for (const char *file : {"individuals.csv.gz", "chain.csv", "manifest.csv", "states/000002.state"}) {
        const TemporaryFolder folder;
        const Spec spec = fake_spec("osc", 3, 4);
        const std::string said = message_of<IoError>([&] {
            RunWriter writer(folder / "run", spec, seed, fake_sources());
            fill_disk_of(folder / ("run/" + std::string(file) + ".tmp"));
            FakeRun run(spec, seed);
            for (int g = 0; g < 3; ++g) run.step(writer, life);
            writer.finish();
        });
        BOOST_TEST(said == "cannot write " + (folder / "run" / std::filesystem::path(file)).string() +
                               ": No space left on device");
        BOOST_TEST(complete_generations(folder / "run") == 0);
    }
}

BOOST_AUTO_TEST_CASE(states_stay_of_generations_25_50_and_every_100_and_of_the_last) {
    for (const int generation : {25, 50, 100, 200, 1900})
        BOOST_TEST(is_kept_generation(generation), generation);
    for (const int generation : {0, 1, 24, 26, 75, 99, 125, 150, 1950})
        BOOST_TEST(!is_kept_generation(generation), generation);
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 104, 2), seed, life);
    BOOST_TEST((kept_generations(place) == std::vector{25, 50, 100, 103}));
    const RecordedRun run = read_run(place);
    for (const int generation : kept_generations(place)) {
        const RunState state = read_run_state(run, fake_spec("osc", 104, 2), generation);
        BOOST_TEST(state.population.generation == generation);
        BOOST_TEST(state.population.genomes.front().id == 2 * generation);
    }
}

BOOST_AUTO_TEST_CASE(leftovers_beside_complete_results_are_removed) {
    const TemporaryFolder folder;
    const std::filesystem::path place = write_with_leftovers(folder);
    tidy_complete_run(place);
    BOOST_TEST((contents(place) == contents(folder / "other")));
}

BOOST_AUTO_TEST_CASE(a_run_in_use_is_not_tidied) {
    const TemporaryFolder folder;
    const std::filesystem::path place = write_with_leftovers(folder);
    const auto before = contents(place);
    const FolderLock lock(place);
    tidy_complete_run(place);
    BOOST_TEST((contents(place) == before));
}

BOOST_AUTO_TEST_CASE(a_run_that_is_not_complete_or_becomes_longer_is_not_tidied) {
    const TemporaryFolder folder;
    quick::run_on(folder / "short", quick::spec("novelty", 3), 2 * quick::population);
    quick::write(folder / "longer", quick::spec("novelty", 3));
    quick::run_on(folder / "longer", quick::spec("novelty", 7), 2 * quick::population);
    for (const std::string name : {"short", "longer"}) {
        const auto before = contents(folder / name);
        tidy_complete_run(folder / name);
        BOOST_TEST((contents(folder / name) == before), name);
    }
}

BOOST_AUTO_TEST_CASE(a_run_that_became_longer_loses_its_earlier_last_state) {
    const TemporaryFolder folder;
    quick::write(folder / "run", quick::spec("novelty", 3));
    BOOST_TEST((kept_generations(folder / "run") == std::vector{2}));
    quick::write(folder / "run", quick::spec("novelty", 5));
    BOOST_TEST((kept_generations(folder / "run") == std::vector{4}));
}
