// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"

#include "base/error.h"
#include "base/random.h"
#include "core/analysis/fake_setting.h"
#include "experiment/sample.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

const std::vector<std::string> tables{"manifest.csv",        "settings.csv",   "runs.csv",
                                      "curves.csv",          "endpoints.csv",  "entropy.csv",
                                      "endpoint_paths.csv",  "outcomes.csv",   "fitness_shares.csv",
                                      "best_genomes.csv",    "archives.csv",   "claims.csv",
                                      "columns.csv",         "parameters.csv", "shape_diversity.csv",
                                      "heredity.csv",        "worlds.csv",     "fitness_history.csv",
                                      "endpoint_density.csv"};

std::vector<Spec> three_settings() {
    return {fake_spec("ns", 12, 10, "novelty"), fake_spec("neat", 12, 10), fake_spec("other", 12, 10)};
}

/// Three seeds of the first two settings; nothing of the third.
void write_runs(const std::filesystem::path &folder) {
    const auto specs = three_settings();
    for (const std::uint64_t seed : {1, 2, 3}) {
        const double lift = static_cast<double>(seed);
        write_fake_run(folder, specs[0], seed, [&](int g, int s) {
            return FakeLife{.fitness = 20 + lift + g + s, .moved = {s - 4.5, 1}, .cells = 10 + s};
        });
        write_fake_run(folder, specs[1], seed, [&](int g, int s) {
            return FakeLife{.fitness = lift + g + s, .moved = {1, 0.1 * s}, .cells = 10 + s % 2};
        });
    }
}

Analysis tiny_analysis() {
    Analysis analysis = fake_analysis();
    analysis.endpoint_settings = {"ns", "neat", "other"};
    analysis.claims = {fake_claim(), fake_claim(), fake_claim()};
    analysis.claims.back().b = "other";
    return analysis;
}

} // namespace

BOOST_AUTO_TEST_CASE(little_data_give_every_table_and_open_claims) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    Analysis analysis = tiny_analysis();
    analysis.design = Parameters{};
    reduce(analysis, three_settings(), {folder / "runs"}, folder / "data");
    for (const std::string &table : tables)
        BOOST_TEST(std::filesystem::exists(folder / "data" / table), table);

    const auto claims = read_table<ClaimRow>(folder / "data");
    BOOST_REQUIRE(claims.size() == 3u);
    BOOST_TEST(claims[0].verdict == "open");
    BOOST_TEST(claims[0].effect.value() == 20);
    BOOST_TEST(claims[0].at_generation == 12);
    BOOST_TEST(contains(claims[0].note, "data end after 12 of 2000 generations; 3 of 20 runs of ns"));
    BOOST_TEST(claims[2].verdict == "open");
    BOOST_TEST(!claims[2].effect.has_value());
    BOOST_TEST(contains(claims[2].note, "no runs of other"));

    const Manifest manifest(folder / "data");
    BOOST_TEST(manifest.text("experiment") == "fake");
    BOOST_TEST(manifest.number("settings") == 3);
    BOOST_TEST(manifest.number("seeds") == 0);
    BOOST_TEST(manifest.number("runs") == 6);
    BOOST_TEST(manifest.number("seeds_planned") == 20);
    BOOST_TEST(manifest.number("generations") == 0);
    BOOST_TEST(manifest.number("evaluations") == 6 * 12 * 10);
    BOOST_TEST(manifest.text("endpoint_share") == "0.5");
    BOOST_TEST(manifest.number("evaluations_planned") == 3LL * 20 * 2000 * 300);
    BOOST_TEST(manifest.number("complete") == 0);
}

BOOST_AUTO_TEST_CASE(a_setting_without_runs_has_no_rows) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    reduce(tiny_analysis(), three_settings(), {folder / "runs"}, folder / "data");
    const auto settings = read_table<SettingRow>(folder / "data");
    BOOST_TEST(settings.size() == 2u);
    BOOST_TEST(settings.at(0).runs == 3);
    BOOST_TEST(read_table<RunRow>(folder / "data").size() == 6u);
    BOOST_TEST(read_table<CurveRow>(folder / "data").size() == 24u);
    BOOST_TEST(read_table<HeredityRow>(folder / "data").size() == 24u);
    BOOST_TEST(read_table<EndpointPathRow>(folder / "data").size() == 48u);
    BOOST_TEST(read_table<FitnessShareRow>(folder / "data").size() == 40u);
    BOOST_TEST(read_table<FitnessHistoryRow>(folder / "data").size() == 480u);
    BOOST_TEST(read_table<ArchivePointRow>(folder / "data").size() == 12u);
}

BOOST_AUTO_TEST_CASE(all_that_was_planned_is_complete_and_decides_claims) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    std::vector<Spec> settings = three_settings();
    settings.pop_back();
    Analysis analysis = tiny_analysis();
    analysis.claims.pop_back();
    analysis.endpoint_settings.pop_back();
    analysis.design.design.seeds = 3;
    analysis.design.design.generations = 12;
    reduce(analysis, settings, {folder / "runs"}, folder / "data");
    BOOST_TEST(Manifest(folder / "data").number("complete") == 1);
    const auto claims = read_table<ClaimRow>(folder / "data");
    BOOST_TEST(claims.at(0).verdict == "reproduced");
    BOOST_TEST(claims.at(0).effect.value() == 20);
    BOOST_TEST(claims.at(0).note == "of the first");
    BOOST_TEST(claims.at(0).p_holm.value() == 0.2, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(claims.at(0).decided_by == "p");
}

BOOST_AUTO_TEST_CASE(a_table_of_the_experiment_is_written_with_its_hash) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    Analysis analysis = tiny_analysis();
    analysis.tables = {{"speeds", [](const RunData &data, Asked &) {
                            const double best = data.settings[0].histories[2].generations[11].best_fitness;
                            return OwnTable{{"setting", "best", "p"}, {{"a, b", best, {}}, {"c", 0.1, 1.0}}};
                        }}};
    reduce(analysis, three_settings(), {folder / "runs"}, folder / "data");
    BOOST_TEST(read_bytes(folder / "data/speeds.csv") == "setting,best,p\n\"a, b\",43,\nc,0.1,1\n");
    const Manifest manifest(folder / "data");
    BOOST_TEST(manifest.text("speeds_sha256") == sha256(read_bytes(folder / "data/speeds.csv")));
}

BOOST_AUTO_TEST_CASE(a_table_without_its_data_is_left_out_which_is_told) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    Analysis analysis = tiny_analysis();
    analysis.tables = {{"speeds", [](const RunData &data, Asked &asked) {
                            asked = {{&data.settings[0]}, 50, true};
                            return OwnTable{};
                        }}};
    make_folder(folder / "data");
    write_bytes(folder / "data/speeds.csv", "old");
    std::string told;
    RunChoice choice{folder / "runs"};
    choice.tell = [&](const std::string &line) { told += line + "\n"; };
    reduce(analysis, three_settings(), choice, folder / "data");
    BOOST_TEST(
        contains(told, "left out: speeds.csv: data end after 12 of 50 generations; 3 of 6 runs of ns"));
    BOOST_TEST(!std::filesystem::exists(folder / "data/speeds.csv"));
    BOOST_TEST(!Manifest(folder / "data").has("speeds_sha256"));
}

BOOST_AUTO_TEST_CASE(the_same_runs_give_the_same_bytes) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    reduce(tiny_analysis(), three_settings(), {folder / "runs"}, folder / "one");
    reduce(tiny_analysis(), three_settings(), {folder / "runs"}, folder / "two");
    for (const std::string &table : tables)
        BOOST_TEST((read_bytes(folder / "one" / table) == read_bytes(folder / "two" / table)), table);
}

BOOST_AUTO_TEST_CASE(a_changed_result_is_found_before_any_table_is_written) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    const auto file = folder / "runs/neat/seed-002/generations.csv";
    std::string text = read_bytes(file);
    text[text.size() - 4] = text[text.size() - 4] == '0' ? '1' : '0';
    write_bytes(file, text);
    BOOST_TEST(message_of<InputError>([&] {
                   reduce(tiny_analysis(), three_settings(), {folder / "runs"}, folder / "data");
               }) == file.string() + ": its content is not what the run's manifest says");
    BOOST_TEST(std::filesystem::is_empty(folder / "data"));
}

BOOST_AUTO_TEST_CASE(tables_that_cannot_be_written_leave_no_manifest) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    reduce(tiny_analysis(), three_settings(), {folder / "runs"}, folder / "data");
    std::filesystem::create_symlink("/dev/full", folder / "data/curves.csv.tmp");
    BOOST_CHECK_THROW(reduce(tiny_analysis(), three_settings(), {folder / "runs"}, folder / "data"), IoError);
    BOOST_TEST(!std::filesystem::exists(folder / "data/manifest.csv"));
}

namespace {

/// Lives that differ between generations, slots and seeds, some of them not viable.
Invent varied(std::uint64_t seed) {
    return [seed](int generation, int slot) -> FakeLife {
        Stream stream(seed, static_cast<std::uint32_t>(generation), static_cast<std::uint32_t>(slot),
                      Purpose::sampling);
        const double luck = stream.uniform();
        if (luck < 0.2) return {.cells = 2, .outcome = Outcome::too_small};
        return {.fitness = luck * (1 + generation), .moved = {luck - 0.5, luck}, .cells = 5 + slot % 9};
    };
}

const RunFacts &first_facts(const ClaimCase &of) {
    return of.data.settings[0].histories[0].after.at(of.generations);
}

Finding first_spread(const ClaimCase &of, Asked &) {
    return {.effect = first_facts(of).size_entropy + first_facts(of).fitness_spread.value(),
            .verdict = "inconclusive"};
}

Finding first_direction(const ClaimCase &of, Asked &) {
    return {.effect = first_facts(of).direction_resultant, .verdict = "inconclusive"};
}

/// An analysis that asks for no more individuals than a sample has.
Analysis sampled_analysis() {
    Analysis analysis = fake_analysis();
    analysis.endpoint_settings = {"ns"};
    analysis.claims = {fake_claim(first_spread), fake_claim(first_direction)};
    analysis.sample_share = recorded_share;
    analysis.sample_least = recorded_least;
    return analysis;
}

/// Two settings of populations of 60. A sample is smaller than the run from generation 17 on.
std::vector<Spec> two_settings(int generations, Recording record = full_record) {
    std::vector<Spec> settings{fake_spec("ns", generations, 60, "novelty"),
                               fake_spec("neat", generations, 60)};
    for (Spec &spec : settings) spec.record = record;
    return settings;
}

void write_varied(const std::filesystem::path &folder, const std::vector<Spec> &settings,
                  const std::vector<std::uint64_t> &seeds = {1, 2}) {
    for (const Spec &spec : settings)
        for (const std::uint64_t seed : seeds) write_fake_run(folder, spec, seed, varied(seed));
}

void check_equal(const std::filesystem::path &one, const std::filesystem::path &two) {
    const auto a = contents(one), b = contents(two);
    BOOST_TEST(a.size() == tables.size());
    for (const auto &[file, bytes] : a) BOOST_TEST((b.at(file) == bytes), file);
}

} // namespace

BOOST_AUTO_TEST_CASE(runs_recorded_as_samples_give_the_tables_of_those_recorded_in_full) {
    const TemporaryFolder folder;
    constexpr int generations = 30;
    const auto full = two_settings(generations), sample = two_settings(generations, sample_record);
    write_varied(folder / "full", full);
    write_varied(folder / "sample", sample);
    const auto rows = [&](const char *record) {
        return read_table<IndividualRow>(folder / record / std::filesystem::path("ns/seed-001")).size();
    };
    BOOST_TEST(rows("sample") < rows("full") * 9 / 10);
    reduce(sampled_analysis(), full, {folder / "full"}, folder / "one");
    reduce(sampled_analysis(), sample, {folder / "sample"}, folder / "two");
    check_equal(folder / "one", folder / "two");
    BOOST_TEST(read_table<EndpointRow>(folder / "one").size() > 500u);
}

BOOST_AUTO_TEST_CASE(longer_runs_give_the_tables_of_those_that_end_earlier) {
    const TemporaryFolder folder;
    for (const Recording record : {full_record, sample_record}) {
        const std::string name = name_of(record);
        const auto shorter = two_settings(20, record), longer = two_settings(27, record);
        write_varied(folder / ("short-" + name), shorter);
        write_varied(folder / ("long-" + name), longer);
        reduce(sampled_analysis(), shorter, {folder / ("short-" + name)}, folder / ("one-" + name));
        reduce(sampled_analysis(), shorter, {folder / ("long-" + name)}, folder / ("two-" + name));
        check_equal(folder / ("one-" + name), folder / ("two-" + name));
    }
}

BOOST_AUTO_TEST_CASE(another_result_changes_the_hash_of_the_results) {
    const TemporaryFolder folder;
    const auto settings = two_settings(2);
    const auto hash = [&](const std::string &runs) {
        reduce(sampled_analysis(), settings, {folder / runs}, folder / "data");
        return Manifest(folder / "data").text("results_sha256");
    };
    write_varied(folder / "one", settings, {1, 2});
    write_varied(folder / "two", settings, {1, 3});
    write_varied(folder / "three", settings, {1});
    write_fake_run(folder / "three", settings[0], 2, varied(2));
    write_fake_run(folder / "three", settings[1], 2, varied(4));
    BOOST_TEST(hash("one") != hash("two"));
    BOOST_TEST(hash("one") != hash("three"));
    BOOST_TEST(hash("one") == hash("one"));
}

BOOST_AUTO_TEST_CASE(a_sample_is_not_asked_for_more_than_it_has) {
    const TemporaryFolder folder;
    const auto settings = two_settings(2, sample_record);
    write_varied(folder / "runs", settings);
    for (const auto &[share, least] : {std::pair{0.5, 1000}, {0.01, 1001}}) {
        Analysis analysis = sampled_analysis();
        analysis.sample_share = share, analysis.sample_least = least;
        BOOST_TEST(contains(
            message_of<InputError>([&] { reduce(analysis, settings, {folder / "runs"}, folder / "data"); }),
            "recorded as a sample of 0.01, at least 1000 individuals; sample_share = "));
    }
    BOOST_TEST(!std::filesystem::exists(folder / "data/manifest.csv"));
}

BOOST_AUTO_TEST_CASE(the_runs_of_another_identity_and_of_other_seeds_are_as_if_they_were_not_there) {
    const TemporaryFolder folder;
    const auto settings = two_settings(3);
    write_varied(folder / "all", settings, {1, 2, 3, 4});
    write_varied(folder / "two", settings, {2, 4});
    auto other = settings;
    for (Spec &spec : other) spec.parameters.land.gravity = 1;
    write_varied(folder / "all", other, {9});
    write_varied(folder / "all", two_settings(2), {8});
    std::vector<std::string> told;
    const RunChoice chosen{folder / "all", {2, 4}, [&](const std::string &line) { told.push_back(line); }};
    reduce(sampled_analysis(), settings, chosen, folder / "one");
    reduce(sampled_analysis(), settings, {folder / "two"}, folder / "other");
    check_equal(folder / "one", folder / "other");
    BOOST_TEST(told.empty()); // the others are not asked for

    // If they are asked for, they are reported as missing.
    const RunChoice all{chosen.folder, {2, 4, 8, 9}, chosen.tell};
    reduce(sampled_analysis(), settings, all, folder / "again");
    check_equal(folder / "again", folder / "other");
    BOOST_REQUIRE(told.size() == 8u);
    BOOST_TEST(told[0] == "left out: " + (folder / "all/ns/seed-008").string() +
                              ": 2 generations, where 3 are asked for");
    BOOST_TEST(told[1] == "left out: " + (folder / "all/ns/seed-009").string() +
                              ": another run: parameter gravity: recorded with 1, asked for with 5");
    BOOST_TEST(told[2] == "missing: " + (folder / "all/ns/seed-008").string());
}

BOOST_AUTO_TEST_CASE(two_processes_do_not_write_into_one_folder) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    const auto refused = [&] {
        return message_of<CreateError>(
            [&] { reduce(tiny_analysis(), three_settings(), {folder / "runs"}, folder / "data"); });
    };
    {
        const FolderLock first = hold_for_tables(folder / "data");
        BOOST_TEST(refused() == (folder / "data").string() + " is in use by another process");
        BOOST_TEST(std::filesystem::is_empty(folder / "data"));
    }
    BOOST_TEST(refused() == "");
}

BOOST_AUTO_TEST_CASE(tables_are_not_written_into_the_folder_of_a_run) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    const auto place = folder / "runs/ns/seed-001";
    const auto bytes = contents(place);
    BOOST_TEST(contains(
        message_of<CreateError>([&] { reduce(tiny_analysis(), three_settings(), {folder / "runs"}, place); }),
        "is the folder of a run, whose files would be replaced: give another --out"));
    BOOST_TEST((contents(place) == bytes));
}
