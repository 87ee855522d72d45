// SPDX-License-Identifier: MIT
#include "record/run_writer.h"

#include "base/error.h"
#include "core/record/fake_run.h"
#include "record/genome_table.h"
#include "record/run_reader.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

constexpr std::uint64_t seed = 5;

/// Fitness rises in generations 0 and 2; slot 1 dies out.
FakeLife life(int generation, int slot) {
    if (slot == 1) return {.cells = 0, .outcome = Outcome::died_out};
    const double fitness = generation == 2 ? 8 : 4;
    return {.fitness = fitness - slot, .moved = {3, 4}, .cells = 20 + slot};
}

const std::vector<std::string> result_files{"experiment.lua",     "resolved.lua",  "generations.csv",
                                            "individuals.csv.gz", "champions.csv", "best_genome.csv"};

} // namespace

BOOST_AUTO_TEST_CASE(a_run_is_complete_only_when_it_is_finished) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const std::filesystem::path place = run_folder(folder.path(), "osc", seed);
    BOOST_TEST(place == folder / "osc/seed-005");
    {
        RunWriter writer(place, spec, seed, fake_identity());
        Population population = fake_population(spec, seed);
        FakeSearch search;
        for (int g = 0; g < 3; ++g) observe_fake(writer, spec, population, search, g, life);
        BOOST_TEST(!is_complete(place, spec, seed, fake_identity()));
        BOOST_TEST(!std::filesystem::exists(place / "individuals.csv.gz"));
        writer.finish();
    }
    BOOST_TEST(is_complete(place, spec, seed, fake_identity()));
    for (const std::string &file : result_files) BOOST_TEST(std::filesystem::exists(place / file), file);
    BOOST_TEST(!std::filesystem::exists(place / "archive.csv"));
}

BOOST_AUTO_TEST_CASE(an_interrupted_run_leaves_neither_tables_nor_temporaries) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    {
        RunWriter writer(folder / "run", spec, seed, fake_identity());
        Population population = fake_population(spec, seed);
        FakeSearch search;
        observe_fake(writer, spec, population, search, 0, life);
    }
    BOOST_TEST(!is_complete(folder / "run", spec, seed, fake_identity()));
    for (const auto &entry : std::filesystem::directory_iterator(folder / "run"))
        BOOST_TEST(entry.path().extension() == ".lua", entry.path());
}

BOOST_AUTO_TEST_CASE(a_run_that_starts_again_is_incomplete_from_its_first_moment) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    RunWriter writer(place, spec, seed, fake_identity());
    BOOST_TEST(!is_complete(place, spec, seed, fake_identity()));
    BOOST_TEST(!std::filesystem::exists(place / "generations.csv"));
}

BOOST_AUTO_TEST_CASE(a_run_is_another_with_another_seed_script_or_name) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    BOOST_TEST(is_complete(place, spec, seed, fake_identity()));
    BOOST_TEST(!is_complete(place, spec, seed + 1, fake_identity()));
    BOOST_TEST(!is_complete(place, spec, seed, fake_identity("resolved otherwise")));
    BOOST_TEST(!is_complete(place, fake_spec("grn", 3, 4), seed, fake_identity()));
}

BOOST_AUTO_TEST_CASE(a_damaged_manifest_counts_as_none) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    const std::string whole = read_bytes(place / "manifest.csv");
    const std::size_t last_row = whole.rfind("status");
    for (std::size_t size = 0; size < whole.size(); size += 7) {
        write_bytes(place / "manifest.csv", whole.substr(0, std::min(size, last_row)));
        BOOST_TEST(!is_complete(place, spec, seed, fake_identity()));
    }
}

BOOST_AUTO_TEST_CASE(the_same_run_is_written_with_the_same_bytes) {
    const TemporaryFolder one, two;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto a = write_fake_run(one.path(), spec, seed, life, 0.5);
    const auto b = write_fake_run(two.path(), spec, seed, life, 0.5);
    for (const auto &entry : std::filesystem::directory_iterator(a))
        BOOST_TEST((read_bytes(entry.path()) == read_bytes(b / entry.path().filename())), entry.path());
}

BOOST_AUTO_TEST_CASE(the_results_hash_is_of_the_tables_alone) {
    const TemporaryFolder one, two;
    const Spec spec = fake_spec("osc", 3, 4);
    const Manifest a(write_fake_run(one.path(), spec, seed, life)),
        b(write_fake_run(two.path(), spec, seed + 1, life));
    Manifest renamed;
    for (const ManifestRow &row : a.rows())
        renamed.add(row.key, contains(row.key, ".lua") ? "other" : row.value);
    BOOST_TEST(results_sha256(renamed) == a.text("results_sha256"));
    // Another seed has other weights in its best genome.
    BOOST_TEST(b.text("results_sha256") != a.text("results_sha256"));
}

BOOST_AUTO_TEST_CASE(a_second_process_does_not_get_the_folder) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    RunWriter writer(folder.path(), spec, seed, fake_identity());
    BOOST_CHECK_THROW(RunWriter(folder.path(), spec, seed, fake_identity()), CreateError);
}

BOOST_AUTO_TEST_CASE(generations_are_counted_as_they_were) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4), seed, life);
    const auto rows = read_table<GenerationRow>(place);
    BOOST_REQUIRE(rows.size() == 3u);
    BOOST_TEST(rows[2].generation == 2);
    BOOST_TEST(rows[2].best_fitness == 8);
    BOOST_TEST(rows[2].best_slot == 0);
    BOOST_TEST(rows[2].mean_fitness == (8 + 0 + 6 + 5) / 4.0);
    BOOST_TEST(rows[2].valid == 3);
    BOOST_TEST(rows[2].viable == 3);
    BOOST_TEST(rows[2].died_out == 1);
    BOOST_TEST(rows[2].overborn == 0);
    BOOST_TEST(rows[2].species == 1);
    BOOST_TEST(rows[2].mean_links == 54);
    BOOST_TEST(rows[2].mean_hidden == 0);
}

BOOST_AUTO_TEST_CASE(every_individual_has_its_row) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4), seed, life);
    const auto rows = read_table<IndividualRow>(place);
    BOOST_REQUIRE(rows.size() == 12u);
    const IndividualRow &row = rows[2 * 4 + 3];
    BOOST_TEST(row.generation == 2);
    BOOST_TEST(row.slot == 3);
    BOOST_TEST(row.genome == 11);
    BOOST_TEST(row.mother == -1);
    BOOST_TEST(row.origin == "initial");
    BOOST_TEST(row.species == 7);
    BOOST_TEST(row.fitness == 5);
    BOOST_TEST(row.outcome == "viable");
    BOOST_TEST(row.cells == 23);
    BOOST_TEST(row.end_x == 3.25);
    BOOST_TEST(row.rest_y == 0.5);
    BOOST_TEST(rows[1].outcome == "died_out");
    BOOST_TEST(rows[1].penalty == 0);
}

BOOST_AUTO_TEST_CASE(a_champion_is_recorded_each_time_the_best_fitness_rises) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4), seed, life);
    const auto rows = read_table<ChampionRow>(place);
    BOOST_REQUIRE(rows.size() == 2u);
    BOOST_TEST(rows[0].generation == 0);
    BOOST_TEST(rows[1].generation == 2);
    BOOST_TEST(rows[1].fitness == 8);
    BOOST_TEST(rows[1].displacement == 5);
    BOOST_TEST(rows[1].x == 3);
    // The fake lives move evenly, so that the last quarter makes a quarter of the way.
    BOOST_TEST(rows[1].late_share == 0.25, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(rows[1].late_actuation == 0.375);
}

BOOST_AUTO_TEST_CASE(the_best_genome_is_the_last_champions) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    Genome expected = fake_population(spec, seed).genomes[0];
    expected.id = 8;
    BOOST_TEST((genome_of(read_table<GenomeRow>(place)) == expected));
}

BOOST_AUTO_TEST_CASE(every_champion_has_its_genome_in_the_record) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    const auto champions = read_numbered<ChampionGenomeRow>(place);
    BOOST_REQUIRE(champions.size() == 2u);
    BOOST_TEST(champions[0].number == 0);
    BOOST_TEST(champions[0].genome.id == 0);
    BOOST_TEST(champions[1].number == 2);
    BOOST_TEST((champions[1].genome == genome_of(read_table<GenomeRow>(place))));
}

BOOST_AUTO_TEST_CASE(the_last_generation_has_its_genomes_in_the_record) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    std::vector<Genome> last = fake_population(spec, seed).genomes;
    for (std::size_t slot = 0; slot < last.size(); ++slot) last[slot].id = 2 * 4 + static_cast<int>(slot);
    BOOST_TEST((read_last_population(read_run(place)) == last));

    // Without its second slot it is no population.
    std::vector<PopulationRow> rows = read_table<PopulationRow>(place);
    std::erase_if(rows, [](const PopulationRow &row) { return row.slot == 1; });
    write_table<PopulationRow>(place, rows);
    BOOST_TEST(contains(message_of<InputError>([&] { read_last_population(read_run(place)); }),
                        "population.csv.gz: slot 1 is missing"));
}

BOOST_AUTO_TEST_CASE(every_species_has_a_row_in_every_generation) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 1, 4);
    {
        RunWriter writer(folder / "run", spec, seed, fake_identity());
        Population population = fake_population(spec, seed);
        Species young{.id = 9, .representative = population.genomes[1], .age = 3, .stagnation = 2};
        young.members = {1, 2, 3};
        young.best_ever = 2.5, young.best = true;
        population.species[0].members = {0};
        population.species.push_back(young);
        FakeSearch search;
        observe_fake(writer, spec, population, search, 0, life);
        writer.finish();
    }
    const auto rows = read_table<SpeciesRow>(folder / "run");
    BOOST_REQUIRE(rows.size() == 2u);
    BOOST_TEST(rows[0].species == 7);
    BOOST_TEST(rows[0].size == 1);
    BOOST_TEST(rows[0].best_score == 4);
    BOOST_TEST(rows[0].mark == 0);
    const SpeciesRow &row = rows[1];
    BOOST_TEST(row.generation == 0);
    BOOST_TEST(row.species == 9);
    BOOST_TEST(row.size == 3);
    BOOST_TEST(row.age == 3);
    BOOST_TEST(row.stagnation == 2);
    BOOST_TEST(row.mark == 1);
    BOOST_TEST(row.best_score == 2);
    BOOST_TEST(row.mean_score == 1);
    BOOST_TEST(row.best_ever == 2.5);
    BOOST_TEST(row.representative == 1);
}

BOOST_AUTO_TEST_CASE(diversity_of_shapes_is_that_of_the_viable) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 1, 3);
    RunWriter writer(folder / "run", spec, seed, fake_identity());
    const Population population = fake_population(spec, seed);
    std::vector<Life> lives(3);
    const std::vector<Vec2d> line{{0, 0}, {1, 0}, {2, 0}}, corner{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    lives[0].shape = lives[1].shape = shape_distribution(line);
    lives[2].shape = shape_distribution(corner);
    lives[0].outcome = lives[2].outcome = Outcome::viable;
    lives[1].outcome = Outcome::never_settled;
    const std::vector<Evaluation> evaluations(3);
    const std::vector<double> scores(3);
    writer.observe({0, population, lives, evaluations, scores, FakeSearch(), 0, {}});
    writer.finish();
    const double expected = shape_distance(lives[0].shape, lives[2].shape);
    BOOST_TEST(expected > 0.1);
    BOOST_TEST(read_table<GenerationRow>(folder / "run").at(0).shape_diversity == expected);
}

BOOST_AUTO_TEST_CASE(an_archive_is_written_for_searches_that_have_one) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4), seed, life, 0.5);
    const auto archive = read_archive(place);
    BOOST_REQUIRE(archive.size() == 3u);
    BOOST_TEST(archive[2].generation == 2);
    BOOST_TEST(archive[2].novelty == 3.5);
    BOOST_TEST(Manifest(place).has("archive.csv"));
}

BOOST_AUTO_TEST_CASE(a_life_with_a_number_that_is_not_finite_is_a_broken_promise) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    RunWriter writer(folder.path(), spec, seed, fake_identity());
    Population population = fake_population(spec, seed);
    FakeSearch search;
    BOOST_CHECK_THROW(observe_fake(writer, spec, population, search, 0,
                                   [](int, int) { return FakeLife{.elongation = std::nan("")}; }),
                      InternalError);
}

BOOST_AUTO_TEST_CASE(a_full_disk_ends_the_run_without_a_manifest) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    make_folder(folder / "run");
    std::filesystem::create_symlink("/dev/full", folder / "run/individuals.csv.gz.tmp");
    const std::string said = message_of<IoError>([&] {
        RunWriter writer(folder / "run", spec, seed, fake_identity());
        Population population = fake_population(spec, seed);
        FakeSearch search;
        for (int g = 0; g < 3; ++g) observe_fake(writer, spec, population, search, g, life);
        writer.finish();
    });
    BOOST_TEST(said ==
               "cannot write " + (folder / "run/individuals.csv.gz").string() + ": No space left on device");
    BOOST_TEST(!is_complete(folder / "run", spec, seed, fake_identity()));
}
