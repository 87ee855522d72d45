// SPDX-License-Identifier: MIT
// Complete runs that become longer.
#include "record/run_writer.h"

#include "base/error.h"
#include "base/text.h"
#include "core/record/quick_run.h"
#include "record/run_reader.h"
#include "storage/input.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::quick;
namespace fs = std::filesystem;

namespace {

/// The same run, started with this number of generations.
std::map<std::string, std::string> at_once(const std::string &search, int generations) {
    const TemporaryFolder folder;
    quick::write(folder / "run", quick::spec(search, generations));
    return contents(folder / "run");
}

void duplicate(const fs::path &from, const fs::path &to) { fs::copy(from, to, fs::copy_options::recursive); }

/// A process that becomes longer and is killed before it puts the first table under its name.
void kill_before_publishing(const fs::path &folder, const Spec &spec) {
    const fs::path table = folder / "generations.csv.tmp";
    fs::create_symlink("/dev/full", table);
    BOOST_CHECK_THROW(run_on(folder, spec), IoError);
    fs::remove(table);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_run_that_becomes_longer_equals_one_started_at_that_length) {
    for (const std::string search : {"neat", "novelty"}) {
        const TemporaryFolder folder;
        for (const int generations : {1, 3, 7}) {
            quick::write(folder / "run", quick::spec(search, generations));
            BOOST_TEST((contents(folder / "run") == at_once(search, generations)), generations);
        }
    }
}

BOOST_AUTO_TEST_CASE(a_run_whose_kept_states_before_the_last_were_removed_becomes_longer) {
    const TemporaryFolder folder;
    const fs::path place = folder / "run";
    quick::write(place, quick::spec("novelty", 27));
    fs::remove(state_path(place, 25));
    quick::write(place, quick::spec("novelty", 29));
    BOOST_CHECK_NO_THROW(check_files(open_run(place)));
    auto whole = at_once("novelty", 29);
    BOOST_TEST(whole.erase("states/000025.state") == 1u);
    for (const auto &[file, bytes] : contents(place))
        if (file != "manifest.csv") BOOST_TEST((whole.at(file) == bytes), file);
}

BOOST_AUTO_TEST_CASE(a_shorter_run_than_there_is_changes_nothing) {
    const TemporaryFolder folder;
    quick::write(folder / "run", quick::spec("novelty", 5));
    const auto before = contents(folder / "run");
    for (const int generations : {1, 4, 5}) {
        quick::write(folder / "run", quick::spec("novelty", generations));
        BOOST_TEST((contents(folder / "run") == before));
    }
}

BOOST_AUTO_TEST_CASE(a_run_that_is_becoming_longer_is_complete_with_its_earlier_length) {
    for (const std::string search : {"neat", "novelty"}) {
        const auto whole = at_once(search, 7);
        for (const End end : {End::stopped, End::killed})
            for (const int evaluations : {1, 2 * population + 1, 4 * population + 2}) {
                const TemporaryFolder folder;
                const fs::path place = folder / "run";
                quick::write(place, quick::spec(search, 3));
                for (int starts = 0; starts < 3; ++starts) {
                    if (run_on(place, quick::spec(search, 7), evaluations, end)) break;
                    const RecordedRun run = open_run(place);
                    BOOST_TEST(run.generations == 3);
                    BOOST_CHECK_NO_THROW(check_files(run));
                }
                BOOST_TEST(run_on(place, quick::spec(search, 7)));
                BOOST_TEST((contents(place) == whole), search << ", " << evaluations);
            }
    }
}

BOOST_AUTO_TEST_CASE(asking_for_complete_generations_does_not_shorten_an_unfinished_run) {
    const auto whole = at_once("novelty", 7);
    for (const End end : {End::stopped, End::killed})
        for (const int evaluations : {2 * population, 4 * population + 1}) {
            const TemporaryFolder folder;
            quick::write(folder / "run", quick::spec("novelty", 3));
            run_on(folder / "run", quick::spec("novelty", 7), evaluations, end, 100);
            const auto before = contents(folder / "run");
            BOOST_TEST(RunWriter(folder / "run", quick::spec("novelty", 3), quick::seed, fake_sources())
                           .is_complete());
            if (end == End::stopped) BOOST_TEST((contents(folder / "run") == before));
            BOOST_TEST(run_on(folder / "run", quick::spec("novelty", 7)));
            BOOST_TEST((contents(folder / "run") == whole));
        }
}

BOOST_AUTO_TEST_CASE(a_process_killed_in_the_last_generation_leaves_a_state_to_resume_from) {
    // No checkpoint on the way: the state before the last generation is the newest.
    for (const std::string search : {"neat", "novelty"}) {
        const TemporaryFolder folder;
        quick::write(folder / "run", quick::spec(search, 3));
        run_on(folder / "run", quick::spec(search, 7), 4 * population + 1, End::killed, 100);
        BOOST_TEST(!fs::exists(folder / "run/checkpoint"));
        {
            RunWriter writer(folder / "run", quick::spec(search, 7), quick::seed, fake_sources());
            BOOST_TEST(writer.take_state().value().population.generation == 6);
        }
        BOOST_TEST(run_on(folder / "run", quick::spec(search, 7)));
        BOOST_TEST((contents(folder / "run") == at_once(search, 7)));
    }
}

BOOST_AUTO_TEST_CASE(a_run_killed_while_its_tables_are_replaced_resumes_to_the_same_bytes) {
    for (const std::string search : {"neat", "novelty"}) {
        const auto whole = at_once(search, 7);
        for (const int interval : {2, 100}) {
            const TemporaryFolder folder;
            quick::write(folder / "left", quick::spec(search, 3));
            run_on(folder / "left", quick::spec(search, 7), 4 * population, End::killed, interval);
            kill_before_publishing(folder / "left", quick::spec(search, 7));
            BOOST_TEST(!fs::exists(folder / "left/manifest.csv"));

            // So many of the longer tables have come to their places.
            const std::vector<std::string> published{
                "generations.csv", "sizes.csv.gz",  "fitness_classes.csv.gz",  "individuals.csv.gz",
                "species.csv.gz",  "champions.csv", "champion_genomes.csv.gz", "chain.csv"};
            for (std::size_t count = 0; count <= published.size(); ++count) {
                const fs::path place = folder / to_text(static_cast<std::int64_t>(count));
                duplicate(folder / "left", place);
                for (std::size_t i = 0; i < count; ++i)
                    write_bytes(place / published[i], whole.at(published[i]));
                if (count == published.size()) fs::remove(place / "states/000002.state");
                BOOST_TEST(run_on(place, quick::spec(search, 7)));
                BOOST_TEST((contents(place) == whole), count);
            }
        }
    }
}

BOOST_AUTO_TEST_CASE(a_run_killed_after_its_manifest_is_complete_and_loses_its_journals_later) {
    const TemporaryFolder folder;
    const auto whole = at_once("novelty", 5);
    run_on(folder / "run", quick::spec("novelty", 5), 4 * population);
    for (const auto &[file, bytes] : whole) {
        make_folder((folder / "run" / fs::path(file)).parent_path());
        write_bytes(folder / "run" / fs::path(file), bytes);
    }
    BOOST_TEST(fs::exists(folder / "run/checkpoint"));
    // Of a process that began to make it longer, and was killed as it wrote its first state.
    write_bytes(folder / "run/states/000004.state.tmp", "half a state");
    const TemporaryFolder other;
    duplicate(folder / "run", other / "run");
    BOOST_TEST(run_on(folder / "run", quick::spec("novelty", 5)));
    BOOST_TEST((contents(folder / "run") == whole));
    BOOST_TEST(run_on(other / "run", quick::spec("novelty", 7)));
    BOOST_TEST((contents(other / "run") == at_once("novelty", 7)));
}

BOOST_AUTO_TEST_CASE(a_complete_run_whose_state_or_table_was_changed_does_not_become_longer) {
    const TemporaryFolder folder;
    quick::write(folder / "run", quick::spec("novelty", 3));
    const auto refused = [&](const std::string &file, const std::string &bytes) {
        const std::string good = read_bytes(folder / "run" / file);
        write_bytes(folder / "run" / file, bytes);
        const auto before = contents(folder / "run");
        const std::string said =
            message_of<InputError>([&] { run_on(folder / "run", quick::spec("novelty", 7)); });
        BOOST_TEST(contains(said, file), said);
        BOOST_TEST((contents(folder / "run") == before));
        write_bytes(folder / "run" / file, good);
    };
    refused("states/000002.state", "damaged");
    refused("generations.csv", replaced(read_bytes(folder / "run/generations.csv"), "\n1,", "\n2,"));
    refused("chain.csv", read_bytes(folder / "run/chain.csv").substr(0, 200));
    for (const std::string file : {"species.csv.gz", "archive.csv.gz"}) {
        const TemporaryFolder other;
        std::string text = read_file(folder / "run" / fs::path(file));
        ++text[text.find('\n') + 1];
        write_file(other / file, text);
        refused(file, read_bytes(other / file));
    }
    BOOST_TEST(run_on(folder / "run", quick::spec("novelty", 7)));
}
