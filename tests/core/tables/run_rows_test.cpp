// SPDX-License-Identifier: MIT
#include "tables/run_rows.h"

#include "core/tables/fake_generations.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using boost::test_tools::tolerance;

namespace {

/// Calls check(generation) for a first generation of this many invented lives.
template <class Check>
void observe(int population, const std::function<FakeLife(int slot)> &life, Check &&check) {
    FakeRun run(fake_spec("osc", 1, population), 1);
    run.observe([&](int, int slot) { return life(slot); }, check);
}

GenerationRow row_of(int population, const std::function<FakeLife(int slot)> &life) {
    GenerationRow row;
    observe(population, life, [&](const Generation &generation) { row = generation_row(generation, {}); });
    return row;
}

using Counts = std::vector<std::pair<int, int>>;

/// The classes of these fitnesses, as percent and individuals.
Counts classes_of(const std::vector<double> &fitness) {
    Counts counts;
    observe(
        static_cast<int>(fitness.size()),
        [&](int slot) { return FakeLife{.fitness = fitness[static_cast<std::size_t>(slot)]}; },
        [&](const Generation &generation) {
            for (const FitnessClassRow &row : fitness_class_rows(generation))
                counts.emplace_back(row.percent, row.individuals);
        });
    return counts;
}

FakeLife dead(int cells = 0) { return {.fitness = 9, .cells = cells, .outcome = Outcome::died_out}; }

} // namespace

BOOST_AUTO_TEST_CASE(quartiles_are_of_the_valid_alone) {
    // Of 2, 4, 6, 8, 10 the quartiles are 4, 6 and 8; the two that died count for the mean.
    const GenerationRow row =
        row_of(7, [](int slot) { return slot < 5 ? FakeLife{.fitness = 10 - 2.0 * slot} : dead(); });
    BOOST_TEST(row.valid == 5);
    BOOST_TEST(row.fitness_low == 4);
    BOOST_TEST(row.fitness_median == 6);
    BOOST_TEST(row.fitness_high == 8);
    BOOST_TEST(row.mean_fitness == 30.0 / 7);
    const GenerationRow between = row_of(4, [](int slot) { return FakeLife{.fitness = 1.0 + slot}; });
    BOOST_TEST(between.fitness_low == 1.75);
    BOOST_TEST(between.fitness_median == 2.5);
    BOOST_TEST(between.fitness_high == 3.25);
}

BOOST_AUTO_TEST_CASE(without_valid_individuals_the_quartiles_are_zero) {
    const GenerationRow row = row_of(3, [](int) { return dead(); });
    BOOST_TEST(row.valid == 0);
    BOOST_TEST(row.fitness_low == 0);
    BOOST_TEST(row.fitness_median == 0);
    BOOST_TEST(row.fitness_high == 0);
    BOOST_TEST(row.best_fitness == 0);
    BOOST_TEST(row.best_x == 0);
    BOOST_TEST(row.moved == 0);
}

BOOST_AUTO_TEST_CASE(headings_are_unit_vectors_of_all_that_moved) {
    const GenerationRow row = row_of(4, [](int slot) {
        constexpr Vec2d moved[] = {{3, 4}, {-6, 8}, {0, 0}, {10, 0}};
        return FakeLife{.fitness = slot == 1 ? 5.0 : 1.0, .moved = moved[slot]};
    });
    BOOST_TEST(row.moved == 3);
    BOOST_TEST(row.heading_x == 0.6 - 0.6 + 1, tolerance(1e-12));
    BOOST_TEST(row.heading_y == 0.8 + 0.8, tolerance(1e-12));
    BOOST_TEST(row.best_slot == 1);
    BOOST_TEST(row.best_x == -6);
    BOOST_TEST(row.best_y == 8);
}

BOOST_AUTO_TEST_CASE(individuals_near_the_best_have_more_than_nine_tenths_of_its_fitness) {
    // Of 10 the bound is 9, which is not near; the dead one counts among all.
    constexpr double fitness[] = {10, 9.5, 9, 1};
    BOOST_TEST(row_of(5, [&](int slot) {
                   return slot < 4 ? FakeLife{.fitness = fitness[slot]} : dead();
               }).near_best == 0.4);
    BOOST_TEST(row_of(3, [](int) { return FakeLife{.fitness = 2}; }).near_best == 1);
    BOOST_TEST(row_of(3, [](int) { return dead(); }).near_best == 0);
}

BOOST_AUTO_TEST_CASE(a_gait_is_cyclic_if_way_and_signals_last_to_the_end) {
    // The way is even, a quarter of it late. Slot 1 holds its muscles still in the end, slot 2 does not move, slot 3
    // has no fitness.
    const GenerationRow row = row_of(6, [](int slot) {
        constexpr double late[] = {0.1, 0.09, 0.5, 0.5, 0.5, 0.5};
        FakeLife life = slot == 3 ? dead() : FakeLife{.moved = {slot == 2 ? 0.0 : 3.0, 0}};
        life.late_actuation = late[slot];
        return life;
    });
    BOOST_TEST(row.cyclic.value() == 0.6, tolerance(1e-12));
    BOOST_TEST(!row_of(3, [](int) { return dead(); }).cyclic.has_value());
}

BOOST_AUTO_TEST_CASE(sizes_count_those_with_fitness_by_ascending_size) {
    std::vector<SizeRow> rows;
    observe(
        7,
        [](int slot) {
            if (slot == 2) return dead(12);
            if (slot == 3) return FakeLife{.fitness = 0, .cells = 12};
            return FakeLife{.cells = slot % 2 ? 12 : 9};
        },
        [&](const Generation &generation) { rows = size_rows(generation); });
    BOOST_REQUIRE(rows.size() == 2u);
    BOOST_TEST((rows[0].generation == 0 && rows[0].cells == 9 && rows[0].individuals == 3));
    BOOST_TEST((rows[1].generation == 0 && rows[1].cells == 12 && rows[1].individuals == 2));
    observe(
        2, [](int) { return dead(); },
        [](const Generation &generation) { BOOST_TEST(size_rows(generation).empty()); });
}

BOOST_AUTO_TEST_CASE(classes_of_fitness_are_hundredths_of_the_highest_and_exclude_their_upper_end) {
    BOOST_TEST((classes_of({200, 0, 1.9, 2, 3.9, 100, 199.9}) == Counts{{0, 2}, {1, 2}, {50, 1}, {99, 2}}));
    // An individual with exactly 100 % is in the last class.
    BOOST_TEST((classes_of({7, 7, 7}) == Counts{{99, 3}}));
    BOOST_TEST((classes_of({1e-320, 0}) == Counts{{0, 1}, {99, 1}}));
    BOOST_TEST((classes_of({1e308, 1e308, 0}) == Counts{{0, 1}, {99, 2}}));
}

BOOST_AUTO_TEST_CASE(every_whole_percent_begins_its_class) {
    std::vector<double> fitness;
    Counts expected;
    for (int percent = 0; percent <= 100; ++percent) fitness.push_back(percent);
    for (int percent = 0; percent < 99; ++percent) expected.emplace_back(percent, 1);
    expected.emplace_back(99, 2);
    BOOST_TEST((classes_of(fitness) == expected));
}

BOOST_AUTO_TEST_CASE(without_fitness_all_are_in_the_first_class) {
    BOOST_TEST((classes_of({0, 0, 0}) == Counts{{0, 3}}));
}
