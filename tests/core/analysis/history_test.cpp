// SPDX-License-Identifier: MIT
#include "analysis/history.h"

#include "base/error.h"
#include "core/record/fake_run.h"
#include "storage/input.h"

#include <boost/test/unit_test.hpp>
#include <cmath>
#include <numeric>

using namespace planula;
using boost::test_tools::tolerance;

namespace {

/// Fitness slot + 1 times a generation's level; the best go left, right, right, left.
FakeLife life(int generation, int slot) {
    if (slot == 0) return {.cells = 3, .outcome = Outcome::too_small};
    constexpr double levels[] = {1, 3, 2, 2}, sides[] = {-1, 1, 1, -1};
    return {.fitness = levels[generation] * (slot + 1),
            .moved = {sides[generation] * 2.0, 0},
            .cells = slot == 1 ? 10 : 20 + generation};
}

RecordedRun recorded(const TemporaryFolder &folder, int generations = 4, int population = 5) {
    return open_run(write_fake_run(folder.path(), fake_spec("ns", generations, population), 1, life));
}

RunHistory history_of(const RecordedRun &run, int generations) {
    return read_history(run, generations, 4, 1);
}

std::string individuals(const RecordedRun &run) {
    std::string text = header_line<IndividualRow>();
    for (const IndividualRow &row : read_table<IndividualRow>(run.folder)) text += line_of(row);
    return text;
}

} // namespace

BOOST_AUTO_TEST_CASE(facts_are_as_computed_by_hand) {
    const TemporaryFolder folder;
    const RunHistory history = history_of(recorded(folder), 4);
    BOOST_REQUIRE(history.generations.size() == 4u);
    for (int i = 0; i < 4; ++i) {
        BOOST_TEST(history.generations[i].generation == i);
        BOOST_TEST(history.generations[i].best_fitness == std::vector<double>({5, 15, 10, 10})[i]);
    }
    BOOST_TEST(history.generations[3].best_x == -2);
    BOOST_REQUIRE(history.after.size() == 4u);

    // After two generations: sizes 10 (2 times), 20 (3 times), 21 (3 times).
    const RunFacts &early = history.after.at(2);
    BOOST_TEST(early.with_fitness == 8);
    BOOST_TEST(early.size_entropy == -(0.25 * std::log(0.25) + 2 * 0.375 * std::log(0.375)),
               tolerance(1e-12));
    BOOST_TEST(early.champion.fitness == 15);
    BOOST_TEST(early.champion.generation == 1);
    BOOST_TEST(early.side_switches == 1);
    BOOST_TEST(early.direction_resultant.value() < 1e-12);

    // After four: half left and half right; fitness 4, 6, 8, 10 in the last generation.
    const RunFacts &late = history.after.at(4);
    BOOST_TEST(late.champion.fitness == 15);
    BOOST_TEST(late.valid_share == 0.8);
    BOOST_TEST(late.fitness_spread.value() == (8.5 - 5.5) / 10, tolerance(1e-12));
    BOOST_TEST(late.side_switches == 1); // nobody surpasses generation 1
    BOOST_TEST(late.with_fitness == 16);
}

BOOST_AUTO_TEST_CASE(all_in_one_direction_have_the_resultant_one) {
    const TemporaryFolder folder;
    const RunHistory history = history_of(recorded(folder, 1), 1);
    BOOST_TEST(history.after.at(1).direction_resultant.value() == 1, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(an_individual_that_stands_still_has_no_direction_and_no_side) {
    // Slot 0 moves two cells up, ever better, and the others tremble: all that move go one way.
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("ns", 4, 6), 1, [](int generation, int slot) {
        if (slot == 0)
            return FakeLife{.fitness = 9.0 + generation, .moved = {generation % 2 ? 0.5 : -0.5, 2}};
        return FakeLife{.fitness = 1, .moved = {slot % 3 ? -0.9 : 0.9, 0}};
    });
    const RecordedRun run = open_run(place);
    const RunFacts facts = read_history(run, 4, 4, 1).after.at(4);
    BOOST_TEST(facts.direction_resultant.value() == 2 / std::sqrt(4.25), tolerance(1e-12));
    BOOST_TEST(facts.side_switches == 0);
    const RunFacts trembling = read_history(run, 4, 4, 0).after.at(4);
    BOOST_TEST(trembling.direction_resultant.value() < 0.6);
    BOOST_TEST(trembling.side_switches == 3);
    BOOST_TEST(!read_history(run, 4, 4, 3).after.at(4).direction_resultant.has_value());
}

BOOST_AUTO_TEST_CASE(only_a_new_best_so_far_changes_sides) {
    // The best of each generation: where it ends along x, and its fitness.
    constexpr double ends[] = {2, -2, 3, -3, -4, 0.5, 5}, fitness[] = {1, 0.5, 2, 3, 4, 5, 6};
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("ns", 7, 2), 1, [&](int generation, int slot) {
        return FakeLife{.fitness = slot == 0 ? fitness[generation] : 0.1, .moved = {ends[generation], 0}};
    });
    const RunHistory history = read_history(open_run(place), 7, 4, 1);
    for (int generations = 1; generations <= 7; ++generations)
        BOOST_TEST(history.after.at(generations).side_switches ==
                   std::vector({0, 0, 0, 1, 1, 1, 2})[generations - 1]);
}

BOOST_AUTO_TEST_CASE(directions_of_a_long_run_are_those_of_its_sample) {
    // 3000 individuals, of whom 1000 on average are in the sample: their resultant is near that of all, 0.6.
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("ns", 3, 1000), 1, [](int, int slot) {
        return FakeLife{.moved = {slot % 5 == 0 ? -2.0 : 2.0, 0}};
    });
    const double found = read_history(open_run(place), 3, 4, 1).after.at(3).direction_resultant.value();
    BOOST_TEST(found != 0.6);
    BOOST_TEST(std::abs(found - 0.6) < 0.1);
}

BOOST_AUTO_TEST_CASE(fitness_shares_cover_the_last_generation) {
    // 0, 4, 6, 8, 10 over 10 in quarters: 0 in the first, 4 in the second, 6 in the third, the others above.
    const TemporaryFolder folder;
    const RunHistory history = history_of(recorded(folder), 4);
    BOOST_REQUIRE(history.fitness_shares.size() == 4u && history.fitness_shares.back().size() == 4u);
    BOOST_TEST(history.fitness_shares.back()[0] == 0.2, tolerance(1e-12));
    BOOST_TEST(history.fitness_shares.back()[1] == 0.2, tolerance(1e-12));
    BOOST_TEST(history.fitness_shares.back()[2] == 0.2, tolerance(1e-12));
    BOOST_TEST(history.fitness_shares.back()[3] == 0.4, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(the_past_does_not_depend_on_how_long_the_run_went_on) {
    const TemporaryFolder folder;
    const RecordedRun run = recorded(folder);
    const RunHistory part = history_of(run, 2), whole = history_of(run, 4);
    BOOST_TEST(part.after.at(2).size_entropy == whole.after.at(2).size_entropy);
    BOOST_TEST(part.after.at(2).fitness_spread.value() == whole.after.at(2).fitness_spread.value());
    BOOST_TEST(part.generations.size() == 2u);
    BOOST_TEST(part.after.at(2).champion.generation == whole.after.at(2).champion.generation);
    BOOST_TEST(part.after.at(2).direction_resultant.value() == whole.after.at(2).direction_resultant.value());
}

BOOST_AUTO_TEST_CASE(a_run_without_viable_individuals_has_facts) {
    const TemporaryFolder folder;
    const auto place = write_fake_run(folder.path(), fake_spec("ns", 2, 3), 1, [](int, int) {
        return FakeLife{.cells = 0, .outcome = Outcome::died_out};
    });
    const RunHistory history = history_of(open_run(place), 2);
    BOOST_TEST(history.after.at(2).size_entropy == 0);
    BOOST_TEST(!history.after.at(2).fitness_spread.has_value());
    BOOST_TEST(!history.after.at(2).direction_resultant.has_value());
    BOOST_TEST(history.after.at(2).valid_share == 0);
    BOOST_TEST(history.fitness_shares.back()[0] == 1, tolerance(1e-12));
}

BOOST_AUTO_TEST_CASE(individuals_out_of_order_or_missing_are_refused_with_their_line) {
    const TemporaryFolder folder;
    const RecordedRun run = recorded(folder);
    const std::string whole = individuals(run), file = (run.folder / "individuals.csv.gz").string();
    const auto refusal = [&](const std::string &text, int generations = 4) {
        write_file(file, text);
        return message_of<InputError>(
            [&] { each_individual(run, generations, [](const IndividualRow &) {}); });
    };
    BOOST_TEST(refusal(replaced(whole, "\n0,3,", "\n0,2,")) ==
               file + ":5: generation 0, slot 2 does not follow generation 0, slot 2");
    BOOST_TEST(refusal(replaced(whole, "\n1,0,", "\n2,0,")) ==
               file + ":7: generation 2, slot 0 does not follow generation 0, slot 4");
    BOOST_TEST(refusal(replaced(whole, "\n3,4,", "\n3,5,")) ==
               file + ":21: generation 3, slot 5 does not follow generation 3, slot 3");
    BOOST_TEST(refusal(whole.substr(0, whole.find("\n3,4,") + 1)) ==
               file + ":20: individuals are missing at the end");
    BOOST_TEST(refusal(whole.substr(0, whole.find("\n3,4,") + 1), 3) == "");
    BOOST_TEST(refusal(whole) == "");
}

BOOST_AUTO_TEST_CASE(a_sample_of_individuals_may_have_gaps_but_no_disorder) {
    const TemporaryFolder folder;
    RecordedRun run = recorded(folder);
    run.record = sample_record;
    const std::string whole = individuals(run), file = (run.folder / "individuals.csv.gz").string();
    const auto line_at = [&](const std::string &start) {
        const std::size_t at = whole.find(start) + 1;
        return whole.substr(at, whole.find('\n', at) + 1 - at);
    };
    int seen = 0;
    const auto refusal = [&](const std::string &text) {
        write_file(file, text);
        seen = 0;
        return message_of<InputError>(
            [&] { each_individual(run, 4, [&](const IndividualRow &) { ++seen; }); });
    };
    for (const char *gap : {"\n0,0,", "\n1,4,", "\n2,2,", "\n3,4,"}) {
        BOOST_TEST(refusal(replaced(whole, line_at(gap), "")) == "");
        BOOST_TEST(seen == 19);
    }
    BOOST_TEST(refusal(header_line<IndividualRow>()) == "");
    BOOST_TEST(seen == 0);
    BOOST_TEST(contains(refusal(replaced(whole, "\n0,3,", "\n0,2,")), "does not follow"));
    BOOST_TEST(contains(refusal(replaced(whole, "\n2,1,", "\n1,1,")), "does not follow"));
    BOOST_TEST(contains(refusal(replaced(whole, "\n2,1,", "\n2,5,")), "does not follow"));
    BOOST_TEST(contains(refusal(replaced(whole, "\n2,0,", "\n2,-1,")), "does not follow"));
}

BOOST_AUTO_TEST_CASE(generations_and_champions_out_of_order_are_refused_with_their_line) {
    const TemporaryFolder folder;
    const RecordedRun run = recorded(folder);
    const auto refusal = [&](const std::string &name, const std::string &from, const std::string &to) {
        const std::string whole = read_bytes(run.folder / name);
        write_bytes(run.folder / name, replaced(whole, from, to));
        const std::string said = message_of<InputError>([&] { history_of(run, 4); });
        write_bytes(run.folder / name, whole);
        return said;
    };
    BOOST_TEST(contains(refusal("generations.csv", "\n2,", "\n5,"),
                        "generations.csv:4: generation 5 where 2 must follow"));
    BOOST_TEST(contains(refusal("generations.csv", "\n0,5,4,", "\n0,5,9,"),
                        "generations.csv:2: best_slot = 9 in a population of 5"));
    BOOST_TEST(contains(refusal("champions.csv", "\n1,4,", "\n0,4,"),
                        "champions.csv:3: this is not the next champion"));
    BOOST_TEST(contains(refusal("champions.csv", "\n0,4,", "\n2,4,"),
                        "champions.csv:2: this is not the next champion"));
}

BOOST_AUTO_TEST_CASE(sizes_and_classes_out_of_order_are_refused_with_their_line) {
    const TemporaryFolder folder;
    const RecordedRun run = recorded(folder);
    const auto refusal = [&](const std::string &name, const std::string &from, const std::string &to) {
        const std::string whole = read_file(run.folder / name);
        write_file(run.folder / name, replaced(whole, from, to));
        const std::string said = message_of<InputError>([&] { history_of(run, 4); });
        write_file(run.folder / name, whole);
        return said;
    };
    BOOST_TEST(
        contains(refusal("sizes.csv.gz", "\n2,10,", "\n0,10,"), "sizes.csv.gz:6: generation 0 after 1"));
    BOOST_TEST(contains(refusal("fitness_classes.csv.gz", "\n3,99,", "\n3,100,"),
                        "fitness_classes.csv.gz:21: percent = 100"));
}

BOOST_AUTO_TEST_CASE(the_champion_of_a_time_is_the_last_before_it) {
    const TemporaryFolder folder;
    const auto champions = read_champions(recorded(folder));
    BOOST_TEST(champion_after(champions, 1).generation == 0);
    for (const int generations : {2, 3, 4})
        BOOST_TEST(champion_after(champions, generations).generation == 1);
}
