// SPDX-License-Identifier: MIT
#include "analysis/analysis.h"

#include "base/error.h"
#include "core/analysis/fake_setting.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

namespace {

const std::vector<std::string> tables{
    "manifest.csv", "settings.csv",       "runs.csv",     "curves.csv",         "endpoints.csv",
    "entropy.csv",  "endpoint_paths.csv", "outcomes.csv", "fitness_shares.csv", "best_genomes.csv",
    "archives.csv", "claims.csv",         "columns.csv",  "parameters.csv",     "shape_diversity.csv"};

std::vector<Spec> three_settings() {
    return {fake_spec("ns", 12, 10), fake_spec("neat", 12, 10), fake_spec("other", 12, 10)};
}

/// Three seeds of the first two settings; nothing of the third.
void write_runs(const std::filesystem::path &folder) {
    const auto specs = three_settings();
    for (const std::uint64_t seed : {1, 2, 3}) {
        const double lift = static_cast<double>(seed);
        write_fake_run(
            folder, specs[0], seed,
            [&](int g, int s) {
                return FakeLife{.fitness = 20 + lift + g + s, .moved = {s - 4.5, 1}, .cells = 10 + s};
            },
            0.5);
        write_fake_run(folder, specs[1], seed, [&](int g, int s) {
            return FakeLife{.fitness = lift + g + s, .moved = {1, 0.1 * s}, .cells = 10 + s % 2};
        });
    }
}

Analysis tiny_analysis() {
    Analysis analysis = fake_analysis();
    analysis.endpoint_settings = {"ns", "neat", "other"};
    analysis.claims = {fake_claim("best_at_generation", "greater"), fake_claim("size_entropy", "greater")};
    analysis.claims.push_back(fake_claim("direction", "less"));
    analysis.claims.back().b = "other";
    return analysis;
}

} // namespace

BOOST_AUTO_TEST_CASE(little_data_give_every_table_and_open_claims) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    Analysis analysis = tiny_analysis();
    analysis.design = Parameters{};
    reduce(analysis, three_settings(), folder / "runs", folder / "data");
    for (const std::string &table : tables)
        BOOST_TEST(std::filesystem::exists(folder / "data" / table), table);

    const auto claims = read_table<ClaimRow>(folder / "data");
    BOOST_REQUIRE(claims.size() == 3u);
    BOOST_TEST(claims[0].verdict == "open");
    BOOST_TEST(claims[0].effect.value() == 1);
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
    BOOST_TEST(manifest.number("evaluations_planned") == 3LL * 20 * 2000 * 300);
    BOOST_TEST(manifest.number("complete") == 0);
}

BOOST_AUTO_TEST_CASE(a_setting_without_runs_has_no_rows) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    reduce(tiny_analysis(), three_settings(), folder / "runs", folder / "data");
    const auto settings = read_table<SettingRow>(folder / "data");
    BOOST_TEST(settings.size() == 2u);
    BOOST_TEST(settings.at(0).runs == 3);
    BOOST_TEST(read_table<RunRow>(folder / "data").size() == 6u);
    BOOST_TEST(read_table<CurveRow>(folder / "data").size() == 24u);
    BOOST_TEST(read_table<EndpointPathRow>(folder / "data").size() == 48u);
    BOOST_TEST(read_table<FitnessShareRow>(folder / "data").size() == 40u);
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
    analysis.design.seeds = 3;
    analysis.design.generations = 12;
    reduce(analysis, settings, folder / "runs", folder / "data");
    BOOST_TEST(Manifest(folder / "data").number("complete") == 1);
    const auto claims = read_table<ClaimRow>(folder / "data");
    // Three against three cannot fall below p = 0.1.
    BOOST_TEST(claims.at(0).verdict == "inconclusive");
    BOOST_TEST(claims.at(0).p.value() == 0.1, boost::test_tools::tolerance(1e-12));
    BOOST_TEST(claims.at(0).note == "");
}

BOOST_AUTO_TEST_CASE(the_same_runs_give_the_same_bytes) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    reduce(tiny_analysis(), three_settings(), folder / "runs", folder / "one");
    reduce(tiny_analysis(), three_settings(), folder / "runs", folder / "two");
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
                   reduce(tiny_analysis(), three_settings(), folder / "runs", folder / "data");
               }) == file.string() + ": its content is not what the run's manifest says");
    BOOST_TEST(!std::filesystem::exists(folder / "data"));
}

BOOST_AUTO_TEST_CASE(tables_that_cannot_be_written_leave_no_manifest) {
    const TemporaryFolder folder;
    write_runs(folder / "runs");
    reduce(tiny_analysis(), three_settings(), folder / "runs", folder / "data");
    std::filesystem::create_symlink("/dev/full", folder / "data/curves.csv.tmp");
    BOOST_CHECK_THROW(reduce(tiny_analysis(), three_settings(), folder / "runs", folder / "data"), IoError);
    BOOST_TEST(!std::filesystem::exists(folder / "data/manifest.csv"));
}
