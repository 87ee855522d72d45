// SPDX-License-Identifier: MIT
#include "record/run_folder.h"

#include "base/error.h"
#include "core/record/quick_run.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
namespace fs = std::filesystem;

namespace {

constexpr std::uint64_t seed = 5;

FakeLife life(int, int) { return {}; }

RunRecord record_of(const Spec &spec) { return {identity_of(spec, seed), spec.record}; }

/// What is said of a folder that another run is asked for in; neither asking nor writing may change a byte of it.
std::string refusal(const fs::path &folder, const Spec &spec) {
    const auto before = contents(folder);
    int code = 0;
    const std::string said = message_of<CreateError>([&] {
        try {
            RunWriter(folder, spec, seed, fake_sources());
        } catch (const Error &error) {
            code = error.code;
            throw;
        }
    });
    BOOST_TEST(code == 73);
    BOOST_TEST(message_of<CreateError>([&] { check_same_run(folder, record_of(spec)); }) == said);
    BOOST_TEST((contents(folder) == before));
    return said;
}

const std::string advice = "\n  Give another --out, or move the folder away.";

} // namespace

BOOST_AUTO_TEST_CASE(a_folder_has_the_identity_of_its_run_from_the_beginning) {
    const TemporaryFolder folder;
    Spec spec = fake_spec("osc", 3, 4);
    spec.parameters.land.gravity = 1.0 / 3;
    BOOST_TEST(!recorded_run(folder / "run"));
    const RunWriter writer(folder / "run", spec, seed, fake_sources());
    const RunRecord record = recorded_run(folder / "run").value();
    BOOST_TEST(differences(record.identity, identity_of(spec, seed)).empty());
    BOOST_TEST(record.identity.sha256() == identity_of(spec, seed).sha256());
    BOOST_TEST((record.record == full_record));
    BOOST_TEST(*record.identity.find("parameter gravity") == "0.3333333333333333");
}

BOOST_AUTO_TEST_CASE(the_folder_of_another_run_is_refused_with_what_differs_and_left_as_it_is) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto complete = write_fake_run(folder.path(), spec, seed, life);
    const auto begun = folder / "begun", under_way = folder / "under_way";
    { const RunWriter writer(begun, spec, seed, fake_sources()); }
    quick::run_on(under_way, quick::spec(), 2 * quick::population);
    Spec other = spec;
    other.parameters.land.gravity = 1;
    other.judgement[0] = {"fitness", std::string(64, 'b'), "other.lua:7"};
    for (const fs::path &place : {complete, begun})
        BOOST_TEST(refusal(place, other) ==
                   place.string() +
                       " holds another run, which is left as it is:"
                       "\n    function fitness: recorded with that of experiment.lua:1, asked for with "
                       "that of other.lua:7, which means something else"
                       "\n    parameter gravity: recorded with 5, asked for with 1" +
                       advice);
    BOOST_TEST(contains(refusal(under_way, spec), "\n    seed: recorded with 6, asked for with 5"));
    // As long as the identity is the same, it is the same run.
    Spec same = fake_spec("called_otherwise", 99, 4);
    same.title = "Other";
    BOOST_CHECK_NO_THROW(check_same_run(complete, record_of(same)));
}

BOOST_AUTO_TEST_CASE(a_run_is_recorded_in_full_or_as_a_sample_from_beginning_to_end) {
    const TemporaryFolder folder;
    Spec full = fake_spec("osc", 3, 4), sample = full;
    sample.record = sample_record;
    const auto one = write_fake_run(folder / "full", full, seed, life),
               two = write_fake_run(folder / "sample", sample, seed, life);
    BOOST_TEST(refusal(one, sample) ==
               one.string() +
                   " holds this run with record = \"full\", and \"sample\" is asked for; "
                   "it is left as it is." +
                   advice);
    BOOST_TEST(contains(refusal(two, full), "with record = \"sample\", and \"full\" is asked for"));
}

BOOST_AUTO_TEST_CASE(foreign_files_are_not_taken_for_a_run) {
    const Spec spec = fake_spec("osc", 3, 4);
    for (const char *file :
         {"notes.txt", "generations.csv", "manifest.csv", "checkpoint", "states/000001.state"}) {
        const TemporaryFolder folder;
        make_folder((folder / file).parent_path());
        write_bytes(folder / file, "of somebody else");
        const std::string name = fs::path(file).begin()->string();
        BOOST_TEST(refusal(folder.path(), spec) ==
                   folder.path().string() + " holds " + name +
                       " and no identity.csv: it is not a run of this planula, and is left as it is." +
                       advice);
    }
}

BOOST_AUTO_TEST_CASE(files_of_a_process_killed_before_it_names_the_run_do_no_harm) {
    const TemporaryFolder folder;
    make_folder(folder / "run/script");
    write_bytes(folder / "run/script/experiment.lua", "half a scri");
    write_bytes(folder / "run/identity.csv.tmp", "half a ta");
    const Spec spec = fake_spec("osc", 3, 4);
    BOOST_TEST(!recorded_run(folder / "run"));
    write_fake_run_into(folder / "run", spec, seed, life);
    write_fake_run_into(folder / "other", spec, seed, life);
    BOOST_TEST((contents(folder / "run") == contents(folder / "other")));
}

BOOST_AUTO_TEST_CASE(a_file_in_place_of_a_folder_is_refused) {
    const TemporaryFolder folder;
    write_bytes(folder / "run", "a file");
    const Spec spec = fake_spec("osc", 3, 4);
    BOOST_TEST(message_of<CreateError>([&] { RunWriter(folder / "run", spec, seed, fake_sources()); }) ==
               (folder / "run").string() + " is not a folder, so no run can be recorded there");
    BOOST_CHECK_THROW(RunWriter(folder / "run/below", spec, seed, fake_sources()), CreateError);
    BOOST_TEST(read_bytes(folder / "run") == "a file");
}

BOOST_AUTO_TEST_CASE(a_damaged_identity_is_refused_by_name_and_left_alone) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    const std::string whole = read_bytes(place / "identity.csv");
    const auto refused = [&](const std::string &bytes, const std::string &reason) {
        write_bytes(place / "identity.csv", bytes);
        const auto before = contents(place);
        const std::string said =
            message_of<InputError>([&] { RunWriter(place, spec, seed, fake_sources()); });
        BOOST_TEST(contains(said, (place / "identity.csv").string() + ":"), said);
        BOOST_TEST(contains(said, reason), said);
        BOOST_TEST((contents(place) == before));
    };
    for (std::size_t size = 0; size < whole.size(); size += 97) refused(whole.substr(0, size), "");
    // Cut at the end of a line it is a table, but not the whole one.
    const std::size_t last = whole.rfind('\n', whole.size() - 2) + 1;
    BOOST_TEST(whole.substr(last) == "record,full,,\n");
    refused(whole.substr(0, last), "rows are missing at the end");
    refused(replaced(whole, "record,full", "record,most"), "'most' is neither full nor a sample");
    refused(whole + "seed,5,,\n", "the key 'seed' is there twice");
    refused(replaced(whole, "\nseed,", "\nsead,"), "rows are missing at the end");
    refused(replaced(whole, "key,", "kee,"), "column 1 is called 'kee'");
}

BOOST_AUTO_TEST_CASE(a_parameter_that_an_older_record_does_not_know_had_its_standard_value) {
    const TemporaryFolder folder;
    const Spec spec = fake_spec("osc", 3, 4);
    const auto place = write_fake_run(folder.path(), spec, seed, life);
    write_bytes(place / "identity.csv",
                replaced(read_bytes(place / "identity.csv"), "\nparameter gravity,5,,5", ""));
    const RunRecord record = recorded_run(place).value();
    BOOST_TEST(!record.identity.find("parameter gravity"));
    BOOST_TEST(record.identity.sha256() == identity_of(spec, seed).sha256());
    BOOST_CHECK_NO_THROW(check_same_run(place, record_of(spec)));
    Spec other = spec;
    other.parameters.land.gravity = 1;
    BOOST_TEST(contains(message_of<CreateError>([&] { check_same_run(place, record_of(other)); }),
                        "parameter gravity: recorded with 5, asked for with 1"));
}

BOOST_AUTO_TEST_CASE(the_scripts_are_kept_with_the_run) {
    const TemporaryFolder folder;
    Spec spec = fake_spec("osc", 3, 4);
    spec.judgement.push_back({"behaviour", std::string(64, 'c'), "lib/far.lua:12"});
    RunSources sources = fake_sources();
    sources.files.push_back({"lib/far.lua", "lib/far.lua", "return 1"});
    sources.overrides = {{"population", 4}, {"gravity", 1.0 / 3}};
    { const RunWriter writer(folder / "run", spec, seed, sources); }
    const fs::path scripts = script_folder(folder / "run");
    BOOST_TEST(read_bytes(scripts / "experiment.lua") == "return {} -- a script\n");
    BOOST_TEST(read_bytes(scripts / "lib/far.lua") == "return 1");
    BOOST_TEST(read_bytes(scripts / "overrides.csv") ==
               "parameter,value\npopulation,4\ngravity,0.3333333333333333\n");
    BOOST_TEST((script_files(folder / "run") ==
                std::vector{scripts / "experiment.lua", scripts / "lib/far.lua", scripts / "overrides.csv"}));
    // Places are those in the copies.
    std::vector<std::string> places;
    for (const IdentityRow &row : read_table<IdentityRow>(folder / "run"))
        if (!row.place.empty()) places.push_back(row.key + " " + row.place);
    BOOST_TEST(places == (std::vector<std::string>{"function fitness experiment.lua:1",
                                                   "function behaviour lib/far.lua:12"}),
               boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_folder_shows_how_many_generations_are_done) {
    const TemporaryFolder folder;
    const auto lengths = [&] {
        return std::pair{complete_generations(folder / "run"), recorded_generations(folder / "run")};
    };
    BOOST_TEST((lengths() == std::pair{0, 0}));
    quick::run_on(folder / "run", quick::spec("neat", 4), 2 * quick::population);
    BOOST_TEST((lengths() == std::pair{0, 2}));
    quick::write(folder / "run", quick::spec("neat", 4));
    BOOST_TEST((lengths() == std::pair{4, 4}));
    quick::run_on(folder / "run", quick::spec("neat", 9), 3 * quick::population);
    BOOST_TEST((lengths() == std::pair{4, 6}));
}

BOOST_AUTO_TEST_CASE(a_folder_for_tables_has_one_process_and_is_not_that_of_a_run) {
    const TemporaryFolder folder;
    {
        const FolderLock held = hold_for_tables(folder / "data");
        BOOST_CHECK_THROW(hold_for_tables(folder / "data"), CreateError);
    }
    BOOST_CHECK_NO_THROW(hold_for_tables(folder / "data"));
    const auto place = write_fake_run(folder.path(), fake_spec("osc", 3, 4), seed, life);
    const auto before = contents(place);
    BOOST_TEST(message_of<CreateError>([&] { hold_for_tables(place); }) ==
               place.string() + " is the folder of a run, whose files would be replaced: give another --out");
    BOOST_TEST((contents(place) == before));
}

BOOST_AUTO_TEST_CASE(the_folder_of_a_run_has_its_setting_and_its_seed) {
    BOOST_TEST(run_folder("runs", "osc", 5) == fs::path("runs/osc/seed-005"));
    BOOST_TEST(run_folder("runs", "osc", 12345) == fs::path("runs/osc/seed-12345"));
    BOOST_TEST(is_file("chain.csv"));
    BOOST_TEST(is_file("states/000025.state"));
    BOOST_TEST(!is_file("generations"));
}
