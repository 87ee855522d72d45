// SPDX-License-Identifier: MIT
#include "record/run_writer.h"

#include "base/error.h"
#include "core/record/fake_run.h"
#include "experiment/sample.h"
#include "record/chain.h"
#include "record/run_reader.h"
#include "storage/input.h"
#include "tables/csv.h"
#include "tables/genome_table.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <cmath>

using namespace planula;

namespace {

constexpr std::uint64_t seed = 5;

/// Fitness rises in generations 0 and 2; slot 1 dies out.
FakeLife life(int generation, int slot) {
    if (slot == 1) return {.cells = 0, .outcome = Outcome::died_out};
    const double fitness = generation == 2 ? 8 : 4;
    return {.fitness = fitness - slot, .moved = {3, 4}, .cells = 20 + slot};
}

const std::vector<std::string> result_files{"identity.csv",
                                            "script/experiment.lua",
                                            "script/overrides.csv",
                                            "generations.csv",
                                            "sizes.csv.gz",
                                            "fitness_classes.csv.gz",
                                            "individuals.csv.gz",
                                            "species.csv.gz",
                                            "champions.csv",
                                            "champion_genomes.csv.gz",
                                            "chain.csv",
                                            "states/000002.state",
                                            "manifest.csv"};

/// A full disk for one file of a run.
void fill_disk_of(const std::filesystem::path &file) {
    make_folder(file.parent_path());
    std::filesystem::create_symlink("/dev/full", file);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_run_is_complete_only_when_it_is_finished) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const std::filesystem::path place = run_folder(folder.path(), "osc", seed);
    BOOST_TEST(place == folder / "osc/seed-005");
    {
        RunWriter writer(place, spec, seed, fake_sources());
        BOOST_TEST(!writer.is_complete());
        BOOST_TEST(writer.generations() == 3);
        FakeRun run(spec, seed);
        for (int g = 0; g < 3; ++g) run.step(writer, life);
        BOOST_TEST(complete_generations(place) == 0);
        BOOST_TEST(!std::filesystem::exists(place / "individuals.csv.gz"));
        writer.finish();
    }
    BOOST_TEST(complete_generations(place) == 3);
    std::vector<std::string> files;
    for (const auto &[file, bytes] : contents(place)) files.push_back(file);
    std::vector<std::string> expected = result_files;
    std::sort(expected.begin(), expected.end());
    BOOST_TEST(files == expected, boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_run_that_ends_before_its_first_checkpoint_leaves_its_name_and_nothing_else) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    {
        RunWriter writer(folder / "run", spec, seed, fake_sources());
        FakeRun(spec, seed).step(writer, life);
    }
    BOOST_TEST(complete_generations(folder / "run") == 0);
    for (const auto &[file, bytes] : contents(folder / "run"))
        BOOST_TEST((file == "identity.csv" || file.starts_with("script/")), file);
}

BOOST_AUTO_TEST_CASE(a_complete_run_has_nothing_to_do_and_is_left_alone) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4), seed, life);
    const auto before = contents(place);
    for (const int generations : {1, 2, 3}) {
        const RunWriter writer(place, fake_spec("osc", generations, 4), seed, fake_sources());
        BOOST_TEST(writer.is_complete());
        BOOST_TEST((contents(place) == before));
    }
}

BOOST_AUTO_TEST_CASE(a_run_that_another_process_completes_meanwhile_has_nothing_to_do) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    // Both have seen that nothing is done; one gets the folder first.
    check_same_run(folder / "run", {identity_of(spec, seed), spec.record});
    write_fake_run_into(folder / "run", spec, seed, life);
    BOOST_TEST(RunWriter(folder / "run", spec, seed, fake_sources()).is_complete());
}

BOOST_AUTO_TEST_CASE(a_damaged_manifest_is_refused_and_nothing_is_changed) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    const std::string whole = read_bytes(place / "manifest.csv");
    const auto refused = [&](const std::string &bytes, int generations) {
        write_bytes(place / "manifest.csv", bytes);
        const auto before = contents(place);
        const std::string said = message_of<InputError>(
            [&] { RunWriter(place, fake_spec("osc", generations, 4), seed, fake_sources()); });
        BOOST_TEST(contains(said, (place / "manifest.csv").string() + ":"), said);
        BOOST_TEST((contents(place) == before));
    };
    for (std::size_t size = 0; size < whole.size(); size += 41) refused(whole.substr(0, size), 3);
    refused(replaced(whole, "\ngenerations,3", "\ngenerations,2"), 3);
    refused(replaced(whole, "\ngenerations,3", "\ngenerations,2"), 7);
}

BOOST_AUTO_TEST_CASE(a_complete_run_that_lacks_a_file_is_refused_and_nothing_is_changed) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4, "novelty"), seed, life);
    for (const auto &[file, bytes] : contents(place)) {
        if (file == "manifest.csv" || file == "identity.csv") continue;
        std::filesystem::remove(place / file);
        const auto before = contents(place);
        for (const int generations : {3, 7}) {
            const std::string said = message_of<InputError>(
                [&] { RunWriter(place, fake_spec("osc", generations, 4, "novelty"), seed, fake_sources()); });
            BOOST_TEST(contains(said, place.string() + " lacks " + file + ", which its manifest names"),
                       said);
        }
        BOOST_TEST((contents(place) == before), file);
        write_bytes(place / file, bytes);
    }
}

BOOST_AUTO_TEST_CASE(the_same_run_is_written_with_the_same_bytes) {
    const TemporaryFolder one, two;
    const Spec spec = fake_spec("osc", 3, 4, "novelty");
    BOOST_TEST((contents(write_fake_run(one.path(), spec, seed, life)) ==
                contents(write_fake_run(two.path(), spec, seed, life))));
}

BOOST_AUTO_TEST_CASE(a_second_process_does_not_get_the_folder) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    RunWriter writer(folder.path(), spec, seed, fake_sources());
    BOOST_CHECK_THROW(RunWriter(folder.path(), spec, seed, fake_sources()), CreateError);
}

BOOST_AUTO_TEST_CASE(generations_are_counted_as_they_were) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4), seed, life);
    const auto rows = read_table<GenerationRow>(place);
    BOOST_REQUIRE(rows.size() == 3u);
    BOOST_TEST(rows[2].generation == 2);
    BOOST_TEST(rows[2].best_fitness == 8);
    BOOST_TEST(rows[2].best_slot == 0);
    BOOST_TEST(rows[2].best_x == 3);
    BOOST_TEST(rows[2].best_y == 4);
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
    BOOST_TEST(row.finish_x == 3.25);
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

BOOST_AUTO_TEST_CASE(every_champion_has_its_genome_in_the_record) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    const auto champions = read_numbered<ChampionGenomeRow>(place);
    BOOST_REQUIRE(champions.size() == 2u);
    BOOST_TEST(champions[0].number == 0);
    BOOST_TEST(champions[0].genome.id == 0);
    BOOST_TEST(champions[1].number == 2);
    Genome expected = fake_population(spec, seed).genomes[0];
    expected.id = 8;
    BOOST_TEST((champions[1].genome == expected));
}

BOOST_AUTO_TEST_CASE(the_last_generation_has_its_genomes_in_the_record) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    std::vector<Genome> last = fake_population(spec, seed).genomes;
    for (std::size_t slot = 0; slot < last.size(); ++slot) last[slot].id = 2 * 4 + static_cast<int>(slot);
    BOOST_TEST((read_run_state(read_run(place), spec, 2).population.genomes == last));
}

BOOST_AUTO_TEST_CASE(every_species_has_a_row_in_every_generation) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 1, 4);
    {
        RunWriter writer(folder / "run", spec, seed, fake_sources());
        FakeRun run(spec, seed);
        Population &population = run.population();
        Species young{.id = 9, .representative = population.genomes[1], .age = 3, .stagnation = 2};
        young.members = {1, 2, 3};
        young.best_ever = 2.5, young.best = true;
        population.species[0].members = {0};
        population.species.push_back(young);
        run.step(writer, life);
        writer.finish();
    }
    const auto rows = read_table<SpeciesRow>(folder / "run");
    BOOST_REQUIRE(rows.size() == 2u);
    BOOST_TEST(rows[0].species == 7);
    BOOST_TEST(rows[0].size == 1);
    BOOST_TEST(rows[0].best_score == 4);
    BOOST_TEST(rows[0].was_best == 0);
    const SpeciesRow &row = rows[1];
    BOOST_TEST(row.generation == 0);
    BOOST_TEST(row.species == 9);
    BOOST_TEST(row.size == 3);
    BOOST_TEST(row.age == 3);
    BOOST_TEST(row.stagnation == 2);
    BOOST_TEST(row.was_best == 1);
    BOOST_TEST(row.best_score == 2);
    BOOST_TEST(row.mean_score == 1);
    BOOST_TEST(row.best_ever == 2.5);
    BOOST_TEST(row.representative == 1);
}

BOOST_AUTO_TEST_CASE(diversity_of_shapes_is_that_of_the_viable) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 1, 3);
    RunWriter writer(folder / "run", spec, seed, fake_sources());
    const Population population = fake_population(spec, seed);
    std::vector<Life> lives(3);
    const std::vector<Vec2d> line{{0, 0}, {1, 0}, {2, 0}}, corner{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    lives[0].shape = lives[1].shape = shape_distribution(line);
    lives[2].shape = shape_distribution(corner);
    lives[0].outcome = lives[2].outcome = Outcome::viable;
    lives[1].outcome = Outcome::never_settled;
    const std::vector<Evaluation> evaluations(3);
    const std::vector<double> scores(3);
    writer.observe({0, population, lives, evaluations, scores, FakeSearch(), Mothers(), 0, {}});
    writer.finish();
    const double expected = shape_distance(lives[0].shape, lives[2].shape);
    BOOST_TEST(expected > 0.1);
    BOOST_TEST(read_table<GenerationRow>(folder / "run").at(0).shape_diversity == expected);
}

BOOST_AUTO_TEST_CASE(an_archive_is_written_for_searches_that_have_one) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4, "novelty"), seed, life);
    const auto archive = read_archive(place);
    BOOST_REQUIRE(archive.size() == 3u);
    BOOST_TEST(archive[2].generation == 2);
    BOOST_TEST(archive[2].novelty == 3.5);
    BOOST_TEST(archive[2].fitness == 8);
    BOOST_TEST(Manifest(place).has("archive.csv.gz"));
    BOOST_TEST(
        !Manifest(write_fake_run(folder.path(), fake_spec("neat", 3, 4), seed, life)).has("archive.csv.gz"));
}

BOOST_AUTO_TEST_CASE(an_archive_that_stays_empty_is_a_table_without_rows) {
    const TemporaryFolder folder;
    {
        const Spec spec = fake_spec("osc", 1, 2, "novelty");
        RunWriter writer(folder / "run", spec, seed, fake_sources());
        FakeRun run(fake_spec("osc", 1, 2), seed);
        run.observe(life, [&](const Generation &generation) { writer.observe(generation); });
        writer.finish();
    }
    BOOST_TEST(read_file(folder / "run/archive.csv.gz") == archive_header());
    BOOST_TEST(read_archive(folder / "run").empty());
}

BOOST_AUTO_TEST_CASE(a_run_recorded_as_a_sample_differs_in_the_rows_of_individuals_alone) {
    // 60 generations of 40 are 2400 individuals, of whom some thousand are recorded at the end.
    const TemporaryFolder folder;
    Spec spec = fake_spec("osc", 60, 40, "novelty");
    const auto full = write_fake_run(folder / "full", spec, seed, life);
    spec.record = sample_record;
    const auto sample = write_fake_run(folder / "sample", spec, seed, life);
    for (const std::string_view file : run_tables)
        if (file != IndividualRow::file_name)
            BOOST_TEST((read_bytes(full / file) == read_bytes(sample / file)), file);
    std::vector<std::string> expected, found;
    for (const IndividualRow &row : read_table<IndividualRow>(full))
        if (is_in_sample(sample_record, seed, 40, row.generation, row.slot)) expected.push_back(line_of(row));
    for (const IndividualRow &row : read_table<IndividualRow>(sample)) found.push_back(line_of(row));
    BOOST_TEST((found == expected));
    BOOST_TEST(found.size() < 2200u);
    BOOST_TEST(open_run(sample).manifest.text("record") == "sample");
    BOOST_TEST((open_run(sample).record == sample_record));
}

BOOST_AUTO_TEST_CASE(a_life_with_a_number_that_is_not_finite_is_an_internal_error) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    RunWriter writer(folder.path(), spec, seed, fake_sources());
    FakeRun run(spec, seed);
    BOOST_CHECK_THROW(run.step(writer, [](int, int) { return FakeLife{.elongation = std::nan("")}; }),
                      InternalError);
}

BOOST_AUTO_TEST_CASE(a_full_disk_at_the_beginning_leaves_no_run) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto temporary = folder / "run/identity.csv.tmp";
    fill_disk_of(temporary);
    BOOST_CHECK_THROW(RunWriter(folder / "run", spec, seed, fake_sources()), IoError);
    BOOST_TEST(!recorded_run(folder / "run"));
    std::filesystem::remove(temporary);
    BOOST_TEST(!RunWriter(folder / "run", spec, seed, fake_sources()).is_complete());
}
