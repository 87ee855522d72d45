// SPDX-License-Identifier: MIT
// Runs that are stopped, killed and damaged on the way, and what their folders come to in the end.
#include "record/resume_point.h"

#include "base/error.h"
#include "base/state.h"
#include "base/text.h"
#include "core/record/quick_run.h"
#include "storage/packed.h"
#include "storage/sealed.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::quick;
namespace fs = std::filesystem;

namespace {

const std::vector<std::string> journals{
    "generations.csv.part",         "sizes.csv.gz.part",   "fitness_classes.csv.gz.part",
    "individuals.csv.gz.part",      "species.csv.gz.part", "champions.csv.part",
    "champion_genomes.csv.gz.part", "archive.csv.gz.part", "chain.csv.part"};

/// A folder in which generations 0 to 3 of 5 are done, with checkpoints at 2 and at 4, and the state before 4.
void leave_two_checkpoints(const fs::path &folder) {
    run_on(folder, quick::spec(), 2 * population);
    run_on(folder, quick::spec(), 2 * population);
}

/// A run that cannot resume: what is said about it; nothing of it may change.
std::string refusal(const fs::path &folder, const Spec &asked = quick::spec()) {
    const auto before = contents(folder);
    const std::string said = message_of<InputError>([&] { run_on(folder, asked); });
    BOOST_TEST((contents(folder) == before), said);
    return said;
}

void duplicate(const fs::path &from, const fs::path &to) { fs::copy(from, to, fs::copy_options::recursive); }

} // namespace

BOOST_AUTO_TEST_CASE(a_run_without_states_begins_at_its_beginning) {
    const TemporaryFolder folder;
    const ResumePoint point = find_resume_point(folder.path(), "identity", 0);
    BOOST_TEST(!point.kept);
    BOOST_TEST((point.start_of("generations.csv").from == JournalStart::From::nothing));
    BOOST_TEST(point.damaged.empty());
}

BOOST_AUTO_TEST_CASE(the_newest_state_that_can_be_read_is_the_resume_point) {
    const TemporaryFolder folder;
    const fs::path place = folder / "run";
    leave_two_checkpoints(place);
    const std::string identity = recorded_run(place)->identity.sha256();
    const auto expect = [&](const std::string &file, int generation, std::size_t damaged) {
        const ResumePoint point = find_resume_point(place, identity, 0);
        BOOST_TEST(point.file == place / fs::path(file));
        BOOST_TEST(point.kept.value().generation == generation);
        BOOST_TEST((point.tables == JournalStart::From::journal));
        BOOST_TEST(point.damaged.size() == damaged);
        BOOST_TEST(point.start_of("generations.csv").mark.length > 0);
        BOOST_TEST(point.load(place, quick::spec()).population.generation == generation);
    };
    expect("checkpoint", 4, 0);
    write_bytes(place / "checkpoint", "damaged");
    expect("states/000004.state", 4, 1);
    write_bytes(place / "states/000004.state", "damaged");
    expect("checkpoint.previous", 2, 2);
}

BOOST_AUTO_TEST_CASE(a_state_within_the_complete_generations_belongs_to_the_published_tables) {
    const TemporaryFolder folder;
    quick::write(folder / "run", quick::spec("novelty", 3));
    const ResumePoint point =
        find_resume_point(folder / "run", recorded_run(folder / "run")->identity.sha256(), 3);
    BOOST_TEST(point.kept.value().generation == 2);
    BOOST_TEST((point.tables == JournalStart::From::target));
    BOOST_TEST(!is_becoming_longer(folder / "run", 3));
    run_on(folder / "run", quick::spec("novelty", 7), 2 * population);
    BOOST_TEST(is_becoming_longer(folder / "run", 3));
}

BOOST_AUTO_TEST_CASE(a_run_stopped_at_every_generation_leaves_the_same_bytes) {
    for (const std::string search : {"neat", "novelty", "nsga2", "map-elites"}) {
        const TemporaryFolder folder;
        quick::write(folder / "whole", quick::spec(search));
        const auto whole = contents(folder / "whole");
        BOOST_TEST(whole.count("archive.csv.gz") == (search == "neat" ? 0u : 1u));
        // Children are compared with mothers of before the stop.
        BOOST_TEST(read_table<GenerationRow>(folder / "whole").back().kept_fitness.has_value());
        for (const int evaluations : {6, 7, 17})
            for (const End end : {End::stopped, End::killed}) {
                if (end == End::killed && evaluations < 2 * population)
                    continue; // never comes to a checkpoint
                const fs::path place = folder / (to_text(evaluations) + (end == End::killed ? "k" : "s"));
                int starts = 1;
                while (!run_on(place, quick::spec(search), evaluations, end)) ++starts;
                BOOST_TEST(starts >= 2);
                BOOST_TEST((contents(place) == whole));
            }
    }
}

BOOST_AUTO_TEST_CASE(a_run_killed_between_checkpoints_resumes_from_the_last_one) {
    const TemporaryFolder folder;
    quick::write(folder / "whole", quick::spec());
    run_on(folder / "run", quick::spec(), 2 * population);
    const auto stopped = contents(folder / "run");
    run_on(folder / "run", quick::spec(), population);

    // The tables have grown, and the checkpoint is that of two generations; a temporary was left behind.
    write_bytes(folder / "run/checkpoint", stopped.at("checkpoint"));
    write_bytes(folder / "run/generations.csv.tmp", "half a tab");
    write_bytes(folder / "run/checkpoint.tmp", "half a check");
    BOOST_TEST(run_on(folder / "run", quick::spec()));
    BOOST_TEST((contents(folder / "run") == contents(folder / "whole")));
}

BOOST_AUTO_TEST_CASE(a_damaged_state_costs_generations_and_no_result) {
    const TemporaryFolder folder;
    quick::write(folder / "whole", quick::spec());
    const auto whole = contents(folder / "whole");
    leave_two_checkpoints(folder / "left");
    const auto resumes_with = [&](const std::vector<std::string> &damaged, int generation) {
        const fs::path place = folder / to_text(static_cast<std::int64_t>(damaged.size()));
        duplicate(folder / "left", place);
        for (const std::string &file : damaged)
            write_bytes(place / file, read_bytes(place / file).substr(0, 1000));
        {
            RunWriter writer(place, quick::spec(), quick::seed, fake_sources(), 2);
            BOOST_TEST(writer.damaged().size() == damaged.size());
            BOOST_TEST(writer.take_state().value().population.generation == generation);
            // It must not be taken for the one before a new one.
            BOOST_TEST(!fs::exists(place / "checkpoint"));
        }
        BOOST_TEST(run_on(place, quick::spec()));
        BOOST_TEST((contents(place) == whole));
    };
    resumes_with({"checkpoint"}, 4);
    resumes_with({"checkpoint", "states/000004.state"}, 2);
}

BOOST_AUTO_TEST_CASE(with_every_checkpoint_damaged_a_kept_state_is_used) {
    const TemporaryFolder folder;
    quick::write(folder / "whole", quick::spec());
    leave_two_checkpoints(folder / "run");
    for (const char *file : {"checkpoint", "checkpoint.previous"})
        write_bytes(folder / "run" / fs::path(file), "damaged");
    BOOST_TEST(run_on(folder / "run", quick::spec()));
    BOOST_TEST((contents(folder / "run") == contents(folder / "whole")));
}

BOOST_AUTO_TEST_CASE(without_a_state_that_can_be_read_nothing_is_changed) {
    const TemporaryFolder folder;
    leave_two_checkpoints(folder / "run");
    for (const char *file : {"checkpoint", "checkpoint.previous", "states/000004.state"})
        write_bytes(folder / "run" / fs::path(file), "");
    const std::string said = refusal(folder / "run");
    BOOST_TEST(contains(said, (folder / "run").string() + ": no state of the run can be read, " +
                                  (folder / "run/checkpoint").string() + " is damaged"),
               said);
}

BOOST_AUTO_TEST_CASE(a_table_that_was_edited_or_cut_is_refused_by_name) {
    const TemporaryFolder folder;
    leave_two_checkpoints(folder / "left");
    for (const std::string &table : journals)
        for (const bool cut : {false, true}) {
            const std::string good = read_bytes(folder / "left" / table);
            std::string bytes = good;
            if (cut)
                bytes.pop_back();
            else
                bytes[bytes.size() / 2] ^= 1;
            write_bytes(folder / "left" / table, bytes);
            BOOST_TEST(contains(refusal(folder / "left"), table), table);
            write_bytes(folder / "left" / table, good);
        }
    fs::remove(folder / "left/species.csv.gz.part");
    BOOST_TEST(contains(refusal(folder / "left"), "species.csv.gz.part"));
}

BOOST_AUTO_TEST_CASE(an_invalid_checkpoint_is_refused_by_name_and_nothing_is_lost) {
    const TemporaryFolder folder;
    leave_two_checkpoints(folder / "left");
    const std::string whole = read_bytes(folder / "left/checkpoint");
    const auto refused = [&](const std::string &from, const std::string &to) {
        const std::string content = unpack(unseal(whole).value());
        write_bytes(folder / "left/checkpoint", seal(pack(replaced(content, from, to))));
        const std::string said = refusal(folder / "left");
        BOOST_TEST(contains(said, (folder / "left/checkpoint").string() + ": "), said);
    };
    const std::string generation = StateWriter().group("population").integer(4).bytes();
    refused(generation, StateWriter().group("population").integer(-4).bytes());
    refused(generation, StateWriter().group("population").integer(3).bytes());
    refused("novelty search", "novelty sEarch");
    refused("champions.csv", "champions.cvs");
    write_bytes(folder / "left/checkpoint", whole);
    BOOST_TEST(run_on(folder / "left", quick::spec()));
}

BOOST_AUTO_TEST_CASE(a_state_of_another_run_is_refused) {
    const TemporaryFolder folder;
    leave_two_checkpoints(folder / "run");
    Spec other = quick::spec();
    other.parameters.neat.add_node_rate += 0.01;
    leave_two_checkpoints(folder / "here");
    {
        const auto there = folder / "other";
        run_on(there, other, 2 * population);
        run_on(there, other, 2 * population);
    }
    for (const char *file : {"checkpoint", "states/000004.state"}) {
        const auto place = folder / "run" / fs::path(file);
        const std::string own = read_bytes(place);
        if (std::string(file) != "checkpoint") fs::remove(folder / "run/checkpoint");
        write_bytes(place, read_bytes(folder / "other" / fs::path(file)));
        BOOST_TEST(refusal(folder / "run") ==
                   place.string() + ": it is a state of another run. Nothing was changed.");
        write_bytes(place, own);
    }
}

BOOST_AUTO_TEST_CASE(the_state_of_the_judge_is_loaded) {
    const TemporaryFolder folder;
    {
        RunWriter writer(folder / "run", quick::spec(), quick::seed, fake_sources(), 2);
        RunState state = begin(quick::spec(), quick::seed);
        BOOST_CHECK_THROW(
            run(
                quick::spec(), quick::seed, 1, state,
                [&](const Generation &generation) { writer.observe(generation); },
                [&](const RunState &now) { writer.before_generation(now, std::string("mem\0ory", 7)); },
                [asked = 0]() mutable { return asked++ == 2 * population; }),
            Stopped);
        BOOST_TEST(writer.memory().empty());
    }
    const RunWriter writer(folder / "run", quick::spec(), quick::seed, fake_sources());
    BOOST_TEST(writer.memory() == std::string("mem\0ory", 7));
    BOOST_TEST(writer.best_fitness() > 0);
}

BOOST_AUTO_TEST_CASE(a_run_that_is_further_than_asked_for_takes_one_generation_to_its_end) {
    const TemporaryFolder folder;
    run_on(folder / "run", quick::spec("novelty", 9), 4 * population);
    {
        const RunWriter writer(folder / "run", quick::spec("novelty", 3), quick::seed, fake_sources());
        BOOST_TEST(!writer.is_complete());
        BOOST_TEST(writer.generations() == 5);
    }
    BOOST_TEST(run_on(folder / "run", quick::spec("novelty", 3)));
    quick::write(folder / "at_once", quick::spec("novelty", 5));
    BOOST_TEST((contents(folder / "run") == contents(folder / "at_once")));
}

BOOST_AUTO_TEST_CASE(an_unfinished_run_asked_for_fewer_generations_equals_one_of_that_length) {
    const TemporaryFolder folder;
    quick::write(folder / "at_once", quick::spec("neat", 5));
    run_on(folder / "run", quick::spec("neat", 9), 4 * population);
    BOOST_TEST(run_on(folder / "run", quick::spec("neat", 5)));
    BOOST_TEST((contents(folder / "run") == contents(folder / "at_once")));
}
