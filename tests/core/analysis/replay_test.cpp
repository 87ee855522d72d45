// SPDX-License-Identifier: MIT
#include "analysis/replay.h"

#include "base/error.h"
#include "base/text.h"
#include "core/record/quick_run.h"
#include "experiment/digest.h"
#include "record/chain.h"
#include "record/kept_state.h"
#include "tables/csv.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
namespace fs = std::filesystem;

namespace {

constexpr int generations = 28; // states stay of 25 and 27
const StopRequest never = [] { return false; };

/// A run, and all that was seen of it.
struct Seen {
    explicit Seen(const std::string &search) : spec(quick::spec(search, generations)) {
        RunWriter writer(place, spec, quick::seed, fake_sources());
        RunState state = begin(spec, quick::seed);
        writer.before_generation(state, "");
        run(
            spec, quick::seed, 1, state,
            [&](const Generation &g) {
                writer.observe(g);
                contents.push_back(generation_sha256(g));
                auto &slots = individuals.emplace_back();
                for (std::size_t slot = 0; slot < g.lives.size(); ++slot)
                    slots.push_back(
                        {g.population.genomes[slot], g.lives[slot], g.evaluations[slot], g.scores[slot]});
            },
            [&](const RunState &now) { writer.before_generation(now, ""); });
        writer.finish();
    }
    RecordedRun open() const { return open_run(place); }
    Individual had(int generation, int slot) const {
        return replay_individual(open(), spec, generation, slot, 1, never);
    }
    std::string refusal(int generation, int slot) const {
        return message_of<InputError>([&] { had(generation, slot); });
    }

    TemporaryFolder folder;
    fs::path place = folder / "run";
    Spec spec;
    std::vector<std::string> contents;
    std::vector<std::vector<Individual>> individuals;
};

} // namespace

BOOST_AUTO_TEST_CASE(every_individual_is_simulated_again_as_the_run_observed_it) {
    for (const std::string search : {"neat", "novelty"}) {
        const Seen seen(search);
        for (const int generation : {0, 3, 24, 25, 26, 27})
            for (int slot = 0; slot < quick::population; ++slot) {
                const Individual again = seen.had(generation, slot);
                const Individual &then = seen.individuals.at(static_cast<std::size_t>(generation))
                                             .at(static_cast<std::size_t>(slot));
                BOOST_TEST((again.genome == then.genome));
                BOOST_TEST((again.evaluation == then.evaluation));
                BOOST_TEST(again.score == then.score);
                BOOST_TEST((again.life.outcome == then.life.outcome));
                BOOST_TEST(again.life.cells == then.life.cells);
                BOOST_TEST(again.life.births == then.life.births);
                BOOST_TEST(again.life.elongation == then.life.elongation);
                BOOST_TEST((again.life.finish == then.life.finish));
                BOOST_TEST((again.life.path == then.life.path));
            }
    }
}

BOOST_AUTO_TEST_CASE(a_replay_shows_the_generations_asked_for_and_the_states_after_them) {
    const Seen seen("novelty");
    for (const auto &[first, last] : {std::pair{0, 0}, {2, 5}, {24, 26}, {25, 25}, {27, 27}, {26, 27}}) {
        std::vector<std::string> shown;
        std::vector<int> after;
        replay(
            seen.open(), seen.spec, first, last, 2,
            [&](const Generation &g) { shown.push_back(generation_sha256(g)); }, never,
            [&](const RunState &state) { after.push_back(state.population.generation); });
        BOOST_TEST((shown == std::vector(seen.contents.begin() + first, seen.contents.begin() + last + 1)));
        BOOST_TEST(after.back() == last + 1);
    }
}

BOOST_AUTO_TEST_CASE(no_more_is_simulated_than_from_the_nearest_kept_state) {
    const Seen seen("neat");
    for (const auto &[generation, from] : {std::pair{24, 0}, {25, 25}, {26, 25}, {27, 27}}) {
        int lives = 0;
        Spec spec = seen.spec;
        spec.judge = [&, judge = seen.spec.judge](const Life &life) { return ++lives, judge(life); };
        replay_individual(seen.open(), spec, generation, 0, 1, never);
        BOOST_TEST(lives == (generation - from + 1) * quick::population);
    }
}

BOOST_AUTO_TEST_CASE(a_wrong_generation_or_slot_is_refused_with_those_that_there_are) {
    const Seen seen("neat");
    const std::string run = seen.place.string();
    for (const int generation : {-1, 28, 1000})
        BOOST_TEST(seen.refusal(generation, 0) ==
                   run + ": no generation " + to_text(generation) + "; they are 0 to 27");
    for (const int slot : {-1, 6})
        BOOST_TEST(seen.refusal(0, slot) == run + ": no slot " + to_text(slot) + "; they are 0 to 5");
    BOOST_CHECK_THROW(replay(
                          seen.open(), seen.spec, 3, 2, 1, [](const Generation &) {}, never),
                      InternalError);
    BOOST_CHECK_THROW(replay(
                          seen.open(), seen.spec, 0, 28, 1, [](const Generation &) {}, never),
                      InternalError);
}

BOOST_AUTO_TEST_CASE(an_individual_of_another_setting_is_refused) {
    const Seen seen("neat");
    Spec other = seen.spec;
    other.judge = [](const Life &) { return Evaluation{1, {0, 0}, 1}; };
    BOOST_TEST(
        contains(message_of<InputError>([&] { replay_individual(seen.open(), other, 2, 0, 1, never); }),
                 "generation 2 is not what simulating it again gives"));
}

BOOST_AUTO_TEST_CASE(a_damaged_state_is_refused_and_a_stop_ends_the_replay) {
    const Seen seen("neat");
    write_bytes(state_path(seen.place, 25), "damaged");
    BOOST_TEST(seen.refusal(26, 0) == state_path(seen.place, 25).string() + ": the file is damaged");
    BOOST_TEST(seen.refusal(24, 0) == "");
    BOOST_CHECK_THROW(replay_individual(seen.open(), seen.spec, 3, 0, 1, [] { return true; }), Stopped);
}
