// SPDX-License-Identifier: MIT
#include "record/run_reader.h"

#include "base/error.h"
#include "core/record/quick_run.h"
#include "record/kept_state.h"
#include "storage/input.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

FakeLife life(int generation, int slot) { return {.fitness = 1.0 + generation + slot}; }

FoundRuns found_in(const TemporaryFolder &folder, const Spec &spec) {
    return find_runs(folder.path(), spec, spec.parameters.design.generations);
}

} // namespace

BOOST_AUTO_TEST_CASE(complete_runs_are_found_by_seed) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 2, 3);
    for (const std::uint64_t seed : {12, 3, 1000}) write_fake_run(folder.path(), spec, seed, life);
    write_bytes(folder / "osc/notes.txt", "no run");
    make_folder(folder / "osc/pictures");
    const FoundRuns found = found_in(folder, spec);
    BOOST_TEST(found.left_out.empty());
    BOOST_REQUIRE(found.runs.size() == 3u);
    BOOST_TEST(found.runs[0].seed == 3);
    BOOST_TEST(found.runs[1].seed == 12);
    BOOST_TEST(found.runs[2].seed == 1000);
    BOOST_TEST(found.runs[0].folder == folder / "osc/seed-003");
    BOOST_TEST(found.runs[0].setting == "osc");
    BOOST_TEST(found.runs[0].generations == 2);
    BOOST_TEST(found.runs[0].population == 3);
    BOOST_TEST((found.runs[0].record == full_record));
    BOOST_TEST(found.runs[0].identity.sha256() == identity_of(spec, 3).sha256());
}

BOOST_AUTO_TEST_CASE(a_setting_without_a_folder_has_no_runs) {
    const TemporaryFolder folder;
    const FoundRuns found = found_in(folder, fake_spec("grn", 2, 3));
    BOOST_TEST(found.runs.empty());
    BOOST_TEST(found.left_out.empty());
}

BOOST_AUTO_TEST_CASE(a_folder_that_holds_no_run_of_the_setting_is_left_out_with_the_reason) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 5, 3);
    const auto left_out = [&](const std::string &place, const std::string &reason) {
        const FoundRuns found = found_in(folder, spec);
        BOOST_TEST(found.runs.empty());
        BOOST_TEST(found.left_out == std::vector{(folder / ("osc/" + place)).string() + ": " + reason},
                   boost::test_tools::per_element());
        std::filesystem::remove_all(folder / "osc");
    };
    make_folder(folder / "osc/seed-001");
    left_out("seed-001", "no run has begun there");

    make_folder(folder / "osc/seed-001");
    write_bytes(folder / "osc/seed-001/generations.csv", "of an earlier planula");
    left_out("seed-001", "not a run of this planula");

    write_fake_run(folder.path(), fake_spec("osc", 4, 3), 1, life);
    left_out("seed-001", "4 generations, where 5 are asked for");

    std::filesystem::remove(write_fake_run(folder.path(), spec, 1, life) / "manifest.csv");
    left_out("seed-001", "not complete");

    write_fake_run(folder.path(), spec, 1, life);
    std::filesystem::rename(folder / "osc/seed-001", folder / "osc/seed-002");
    left_out("seed-002", "it is a run of seed 1, which does not belong there");

    write_fake_run(folder.path(), spec, 1, life);
    std::filesystem::rename(folder / "osc/seed-001", folder / "osc/seed-1");
    left_out("seed-1", "it is a run of seed 1, which does not belong there");

    Spec other = spec;
    other.parameters.land.gravity = 1;
    write_fake_run(folder.path(), other, 1, life);
    left_out("seed-001", "another run: parameter gravity: recorded with 1, asked for with 5");

    other.parameters.water.drag_normal = 7;
    other.engine = "bullet";
    write_fake_run(folder.path(), other, 1, life);
    left_out("seed-001", "another run: engine: recorded with bullet, asked for with native (and 2 more)");
}

BOOST_AUTO_TEST_CASE(the_name_of_a_setting_is_its_folder_and_no_more) {
    const TemporaryFolder folder;
    write_fake_run(folder.path(), fake_spec("osc", 2, 3), 1, life);
    std::filesystem::rename(folder / "osc", folder / "renamed");
    BOOST_TEST(found_in(folder, fake_spec("renamed", 2, 3)).runs.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_damaged_record_is_refused_and_not_left_out) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 2, 3);
    const auto place = write_fake_run(folder.path(), spec, 1, life);
    for (const std::string file : {"identity.csv", "manifest.csv"}) {
        const std::string whole = read_bytes(place / file);
        for (const double share : {0.0, 0.5, 0.99}) {
            write_bytes(place / file,
                        whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
            const std::string said = message_of<InputError>([&] { found_in(folder, spec); });
            BOOST_TEST(contains(said, (place / file).string()), said);
        }
        write_bytes(place / file, whole);
    }
    write_bytes(place / "identity.csv",
                replaced(read_bytes(place / "identity.csv"), "\nseed,1,", "\nseed,one,"));
    BOOST_TEST(
        contains(message_of<InputError>([&] { found_in(folder, spec); }), "the seed is not a whole number"));
}

BOOST_AUTO_TEST_CASE(an_unchanged_run_agrees_with_its_manifest) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 2, 3, "novelty");
    write_fake_run(folder.path(), spec, 1, life);
    BOOST_CHECK_NO_THROW(check_files(found_in(folder, spec).runs.at(0)));
}

BOOST_AUTO_TEST_CASE(a_changed_byte_of_any_file_is_found_and_the_file_named) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 2, 3, "novelty");
    const auto place = write_fake_run(folder.path(), spec, 1, life);
    const RecordedRun run = open_run(place);
    for (const auto &[file, whole] : contents(place)) {
        if (file == "manifest.csv") continue;
        std::string changed = whole;
        changed[changed.size() / 2] ^= 1;
        write_bytes(place / file, changed);
        BOOST_TEST(
            contains(message_of<InputError>([&] { check_files(run); }), (place / file).string() + ": "),
            file);
        std::filesystem::remove(place / file);
        BOOST_TEST(contains(message_of<InputError>([&] { check_files(run); }), " lacks " + file), file);
        write_bytes(place / file, whole);
    }
}

BOOST_AUTO_TEST_CASE(a_run_that_becomes_longer_while_it_is_read_is_said_to) {
    const TemporaryFolder folder;
    const RecordedRun run = [&] {
        const Spec spec = fake_spec("osc", 2, 3);
        write_fake_run(folder.path(), spec, 1, life);
        return found_in(folder, spec).runs.at(0);
    }();
    const auto message = [&] { return message_of<InputError>([&] { check_files(run); }); };
    std::filesystem::rename(folder / "osc/seed-001/manifest.csv", folder / "manifest.csv");
    BOOST_CHECK_NO_THROW(check_files(run)); // its files are still those that were there
    write_bytes(folder / "osc/seed-001/generations.csv", "replaced");
    BOOST_TEST(contains(message(), "makes this run longer"));
    std::filesystem::rename(folder / "manifest.csv", folder / "osc/seed-001/manifest.csv");
    BOOST_TEST(contains(message(), "its content is not what"));

    std::filesystem::remove_all(folder / "osc");
    write_fake_run(folder.path(), fake_spec("osc", 3, 3), 1, life);
    BOOST_TEST(contains(message(), "makes this run longer"));
}

BOOST_AUTO_TEST_CASE(a_changed_row_in_the_manifest_is_found) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 2, 3), 1, life);
    const std::string whole = read_bytes(place / "manifest.csv");
    for (std::size_t line = whole.find('\n') + 1; line < whole.size(); line = whole.find('\n', line) + 1) {
        std::string changed = whole;
        char &last = changed[changed.find('\n', line) - 1];
        last = last == '0' ? '1' : '0';
        write_bytes(place / "manifest.csv", changed);
        BOOST_TEST(contains(message_of<InputError>([&] { open_run(place); }),
                            "manifest.csv: it is not as it was written"),
                   changed.substr(line, 20));
    }
    write_bytes(place / "manifest.csv", whole);
    BOOST_CHECK_NO_THROW(open_run(place));
}

BOOST_AUTO_TEST_CASE(the_manifest_of_another_run_is_found) {
    const TemporaryFolder folder;
    Spec other = fake_spec("other", 2, 3);
    other.parameters.land.gravity = 1;
    const auto one = write_fake_run(folder.path(), fake_spec("osc", 2, 3), 1, life);
    for (const auto &two : {write_fake_run(folder.path(), fake_spec("osc", 2, 3), 2, life),
                            write_fake_run(folder.path(), other, 1, life)}) {
        write_bytes(one / "manifest.csv", read_bytes(two / "manifest.csv"));
        BOOST_TEST(contains(message_of<InputError>([&] { open_run(one); }),
                            "manifest.csv: it is of another run than identity.csv"));
    }
}

BOOST_AUTO_TEST_CASE(the_champion_of_a_time_has_its_genome) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 4, 3);
    const auto place = write_fake_run(folder.path(), spec, 1, [](int generation, int slot) {
        return FakeLife{.fitness = generation == 1 || generation == 3 ? 10.0 + generation + slot : 1.0};
    });
    const RecordedRun run = open_run(place);
    BOOST_TEST(read_champion_genome(run, 1).id == 0);
    BOOST_TEST(read_champion_genome(run, 2).id == 3 + 2);
    BOOST_TEST(read_champion_genome(run, 3).id == 3 + 2);
    BOOST_TEST(read_champion_genome(run, 4).id == 9 + 2);
    BOOST_TEST(read_champion_genome(run, 4).inputs == input::count);

    const auto refusal = [&](const std::string &text) {
        write_file(place / "champion_genomes.csv.gz", text);
        return message_of<InputError>([&] { read_champion_genome(run, 4); });
    };
    const std::string file = (place / "champion_genomes.csv.gz").string(), text = read_file(file);
    BOOST_TEST(refusal(replaced(text, "bias", "hidden")).starts_with(file + ":"));
    BOOST_TEST(refusal(text.substr(0, text.find('\n') + 1)) == file + ": there is no champion");
}

BOOST_AUTO_TEST_CASE(the_state_before_a_generation_is_the_runs_or_refused) {
    const TemporaryFolder folder;
    const Spec spec = quick::spec("novelty", 3);
    quick::write(folder / "run", spec);
    const RecordedRun run = open_run(folder / "run");
    const RunState state = read_run_state(run, spec, 2);
    BOOST_TEST(state.population.generation == 2);
    BOOST_TEST(!state.search->archive().empty());
    // A setting that asks for fewer generations than the run has reads it as well.
    BOOST_CHECK_NO_THROW(read_run_state(run, quick::spec("novelty", 1), 2));

    const auto file = state_path(folder / "run", 2);
    const std::string whole = read_bytes(file);
    const auto refusal = [&] { return message_of<InputError>([&] { read_run_state(run, spec, 2); }); };
    write_bytes(file, whole.substr(0, whole.size() / 2));
    BOOST_TEST(refusal() == file.string() + ": the file is damaged");
    KeptState kept = (write_bytes(file, whole), read_state(file).value());
    kept.identity = "another";
    keep_state(folder / "run", kept);
    BOOST_TEST(refusal() == file.string() + ": it is a state of another run");
    kept = (write_bytes(file, whole), read_state(file).value());
    --kept.archive;
    keep_state(folder / "run", kept);
    BOOST_TEST(refusal().starts_with(file.string() + ": saved state, byte "));
    kept.archive = 0;
    keep_state(folder / "run", kept);
    BOOST_TEST(refusal().starts_with(file.string() + ": saved state, byte "));
    write_bytes(file, whole);
    std::filesystem::rename(file, state_path(folder / "run", 1));
    BOOST_TEST(contains(message_of<InputError>([&] { read_run_state(run, spec, 1); }),
                        "it is of another generation"));
}

BOOST_AUTO_TEST_CASE(every_run_has_a_status) {
    const TemporaryFolder folder;
    write_fake_run(folder.path(), fake_spec("osc", 2, 3), 2, life);
    make_folder(folder / "osc/seed-001");
    make_folder(folder / "grn/pictures");
    write_bytes(folder / "notes.txt", "no setting");
    quick::run_on(folder / "grn/seed-001", quick::spec("neat", 5), 4 * quick::population);
    quick::write(folder / "grn/seed-006", quick::spec("neat", 2));
    quick::run_on(folder / "grn/seed-006", quick::spec("neat", 9), 2 * quick::population);
    { const RunWriter writer(folder / "wide/seed-001", fake_spec("wide", 2, 100'000), 1, fake_sources()); }
    make_folder(folder / "grn/seed-007");
    write_bytes(folder / "grn/seed-007/generations.csv", "of an earlier planula");
    const auto runs = statuses(folder.path());
    BOOST_REQUIRE(runs.size() == 6u);
    BOOST_TEST(runs[0].folder == folder / "grn/seed-001");
    BOOST_TEST(runs[0].complete == 0);
    BOOST_TEST(runs[0].kept == 4);
    BOOST_TEST(runs[0].population == quick::population);
    std::uintmax_t bytes = 0;
    for (const auto &[file, content] : contents(runs[0].folder)) bytes += content.size();
    BOOST_TEST(runs[0].bytes == bytes);
    BOOST_TEST(runs[1].complete == 2);
    BOOST_TEST(runs[1].kept == 3);
    BOOST_TEST(contains(runs[2].trouble, "it is not a run of this planula"));
    BOOST_TEST(runs[3].folder == folder / "osc/seed-001");
    BOOST_TEST(runs[3].complete == 0);
    BOOST_TEST(runs[3].trouble == "");
    BOOST_TEST(runs[4].complete == 2);
    BOOST_TEST(runs[4].kept == 0);
    BOOST_TEST(runs[5].population == 100'000);
    BOOST_CHECK_THROW(statuses(folder / "nowhere"), InputError);
}

BOOST_AUTO_TEST_CASE(a_single_run_is_read_only_when_it_is_complete_and_as_it_was) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 2, 3), 2, life);
    BOOST_TEST(read_run(place).setting == "osc");
    BOOST_TEST(read_run(place).seed == 2);
    std::string table = read_bytes(place / "generations.csv");
    write_bytes(place / "generations.csv", table + "x");
    BOOST_CHECK_THROW(read_run(place), InputError);
    BOOST_CHECK_NO_THROW(open_run(place));
    std::filesystem::remove(place / "manifest.csv");
    BOOST_TEST(message_of<InputError>([&] { read_run(place); }) ==
               place.string() + " is not the folder of a complete run: it has no manifest.csv");
    BOOST_TEST(message_of<InputError>([&] { read_run(folder.path()); }) ==
               folder.path().string() + " is not the folder of a complete run: it has no identity.csv");
}
