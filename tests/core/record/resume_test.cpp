// SPDX-License-Identifier: MIT
// Runs that are stopped, killed and damaged on the way, and what their directories come to in the end.
#include "record/run_writer.h"

#include "base/error.h"
#include "base/state.h"
#include "core/record/fake_run.h"
#include "record/sealed.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <map>

using namespace planula;

namespace {

constexpr std::uint64_t seed = 6;
constexpr int generations = 5;

/// Lives that are over soon: embryos of a few steps, judged by what their network made of them.
Spec quick(const std::string &search = "novelty") {
    Spec spec = fake_spec("quick", generations, 6);
    spec.search = search;
    spec.environment = specimens::water();
    spec.parameters.locomotion_steps = 20;
    spec.parameters.development_steps = 300;
    spec.parameters.archive_threshold = 0.001;
    spec.judge = [](const Life &life) {
        return Evaluation{life.elongation + life.cells, {life.elongation, life.cells * 0.1}, 1};
    };
    return spec;
}

/// Runs for so many further evaluations, and to the end without a number; then the directory is closed.
bool run_on(const std::filesystem::path &folder, const Spec &spec, int evaluations = -1,
            const RunIdentity &identity = fake_identity()) {
    RunWriter writer(folder, spec, seed, identity, 2);
    std::optional<RunState> left = writer.take_state();
    RunState state = left ? std::move(*left) : begin(spec, seed);
    const std::string memory = writer.memory() + "+";
    try {
        run(
            spec, seed, 1, state, [&](const Generation &generation) { writer.observe(generation); },
            [&](const RunState &now) { writer.between(now, memory); },
            [asked = 0, evaluations]() mutable { return asked++ == evaluations; });
    } catch (const Stopped &) {
        writer.keep(state, memory);
        return false;
    }
    writer.finish();
    return true;
}

std::map<std::string, std::string> contents(const std::filesystem::path &folder) {
    std::map<std::string, std::string> files;
    for (const auto &entry : std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = read_bytes(entry.path());
    return files;
}

/// A directory in which generations 0 to 3 are done, with a checkpoint at 2 and one at 4.
void leave_two_checkpoints(const std::filesystem::path &folder) {
    run_on(folder, quick(), 2 * 6);
    run_on(folder, quick(), 2 * 6);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_run_stopped_at_every_generation_leaves_the_same_bytes) {
    for (const std::string search : {"neat", "novelty"}) {
        const TemporaryFolder folder;
        run_on(folder / "whole", quick(search));
        const auto whole = contents(folder / "whole");
        BOOST_TEST(whole.count("archive.csv") == (search == "novelty" ? 1u : 0u));
        for (const int evaluations : {6, 7, 17}) {
            const std::filesystem::path place = folder / to_text(evaluations);
            int starts = 1;
            while (!run_on(place, quick(search), evaluations)) ++starts;
            BOOST_TEST(starts >= 2);
            BOOST_TEST((contents(place) == whole));
        }
    }
}

BOOST_AUTO_TEST_CASE(a_run_killed_between_checkpoints_goes_on_from_the_last_one) {
    const TemporaryFolder folder;
    run_on(folder / "whole", quick());
    run_on(folder / "run", quick(), 2 * 6);
    const auto stopped = contents(folder / "run");
    run_on(folder / "run", quick(), 6);

    // The tables have grown, and the checkpoint is that of two generations; a temporary was left behind.
    for (const char *file : {"checkpoint"})
        write_bytes(folder / "run" / std::filesystem::path(file), stopped.at(file));
    write_bytes(folder / "run/generations.csv.tmp", "half a tab");
    write_bytes(folder / "run/checkpoint.tmp", "half a check");
    BOOST_TEST(run_on(folder / "run", quick()));
    BOOST_TEST((contents(folder / "run") == contents(folder / "whole")));
}

BOOST_AUTO_TEST_CASE(a_damaged_checkpoint_costs_generations_and_no_result) {
    const TemporaryFolder folder;
    run_on(folder / "whole", quick());
    const auto whole = contents(folder / "whole");
    leave_two_checkpoints(folder / "left");
    for (const bool both : {false, true}) {
        const std::filesystem::path place = folder / (both ? "both" : "one");
        std::filesystem::copy(folder / "left", place);
        write_bytes(place / "checkpoint", read_bytes(place / "checkpoint").substr(0, 1000));
        if (both) write_bytes(place / "checkpoint.previous", "");
        {
            RunWriter writer(place, quick(), seed, fake_identity(), 2);
            BOOST_TEST(writer.damaged().size() == (both ? 2u : 1u));
            const auto state = writer.take_state();
            BOOST_TEST(state.has_value() == !both);
            if (state) BOOST_TEST(state->population.generation == 2);
        }
        BOOST_TEST(run_on(place, quick()));
        BOOST_TEST((contents(place) == whole));
    }
}

BOOST_AUTO_TEST_CASE(a_table_that_was_edited_or_cut_is_refused_by_name) {
    const TemporaryFolder folder;
    leave_two_checkpoints(folder / "left");
    for (const char *table : {"generations.csv.part", "individuals.csv.gz.part", "species.csv.gz.part",
                              "champions.csv.part", "champion_genomes.csv.gz.part"})
        for (const bool cut : {false, true}) {
            std::string bytes = read_bytes(folder / "left" / std::filesystem::path(table));
            const std::string good = bytes;
            if (cut)
                bytes.pop_back();
            else
                bytes[bytes.size() / 2] ^= 1;
            write_bytes(folder / "left" / std::filesystem::path(table), bytes);
            const std::string said = message_of<InputError>([&] { run_on(folder / "left", quick()); });
            BOOST_TEST(contains(said, table), said);
            write_bytes(folder / "left" / std::filesystem::path(table), good);
        }
    BOOST_TEST(run_on(folder / "left", quick()));
}

BOOST_AUTO_TEST_CASE(a_checkpoint_that_makes_no_sense_is_refused_by_name_and_nothing_is_lost) {
    const TemporaryFolder folder;
    leave_two_checkpoints(folder / "left");
    const auto before = contents(folder / "left");
    const auto refused = [&](const std::string &from, const std::string &to) {
        std::string content(unseal(before.at("checkpoint")).value());
        const std::size_t at = content.find(from);
        BOOST_REQUIRE(at != std::string::npos);
        write_bytes(folder / "left/checkpoint", seal(content.replace(at, from.size(), to)));
        const std::string said = message_of<InputError>([&] { run_on(folder / "left", quick()); });
        BOOST_TEST(contains(said, (folder / "left/checkpoint").string() + ": "), said);
    };
    const std::string generation = StateWriter().group("population").integer(4).bytes();
    refused(generation, StateWriter().group("population").integer(-4).bytes());
    refused(generation, StateWriter().group("population").integer(3).bytes());
    refused("novelty search", "novelty sEarch");
    refused("champions.csv", "champions.cvs");
    write_bytes(folder / "left/checkpoint", before.at("checkpoint"));
    BOOST_TEST((contents(folder / "left") == before));
    BOOST_TEST(run_on(folder / "left", quick()));
}

BOOST_AUTO_TEST_CASE(the_checkpoint_of_another_run_is_not_taken_up) {
    const TemporaryFolder folder;
    leave_two_checkpoints(folder / "run");
    RunWriter writer(folder / "run", quick(), seed, fake_identity("resolved otherwise"));
    BOOST_TEST(!writer.take_state());
    BOOST_TEST(writer.memory().empty());
    BOOST_TEST(!std::filesystem::exists(folder / "run/checkpoint"));
    BOOST_TEST(!std::filesystem::exists(folder / "run/checkpoint.previous"));
}

BOOST_AUTO_TEST_CASE(what_the_judge_remembers_comes_back) {
    const TemporaryFolder folder;
    leave_two_checkpoints(folder / "run");
    const RunWriter writer(folder / "run", quick(), seed, fake_identity());
    BOOST_TEST(writer.memory() == "++");
    BOOST_TEST(writer.best_fitness() > 0);
}
