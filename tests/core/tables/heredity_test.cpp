// SPDX-License-Identifier: MIT
#include "tables/heredity.h"

#include "core/tables/fake_generations.h"

#include <boost/test/unit_test.hpp>

#include <limits>

using namespace planula;
using boost::test_tools::tolerance;

namespace {

/// A mother and her child: fitness 0 is that of who died.
struct Pair {
    double mother, child;
    int mother_cells = 10, child_cells = 10;
    Origin origin = Origin::mutation;
};

FakeLife life(double fitness, int cells) {
    return {.fitness = fitness, .cells = cells, .outcome = fitness > 0 ? Outcome::viable : Outcome::died_out};
}

/// The row of a generation whose child in slot i has mother i.
GenerationRow row_of(const std::vector<Pair> &pairs) {
    GenerationRow row;
    FakeRun run(fake_spec("osc", 2, static_cast<int>(pairs.size())), 1);
    const auto invent = [&](int generation, int slot) {
        const Pair &pair = pairs[static_cast<std::size_t>(slot)];
        return generation == 0 ? life(pair.mother, pair.mother_cells) : life(pair.child, pair.child_cells);
    };
    run.observe(invent, [](const Generation &) {});
    for (std::size_t slot = 0; slot < pairs.size(); ++slot) {
        Genome &child = run.population().genomes[slot];
        child.mother = child.id;
        child.id += static_cast<std::int64_t>(pairs.size());
        child.origin = pairs[slot].origin;
    }
    run.observe(invent, [&](const Generation &generation) { add_heredity(generation, row); });
    return row;
}

} // namespace

BOOST_AUTO_TEST_CASE(five_pairs_worked_out_by_hand) {
    const GenerationRow row =
        row_of({{1, 2, 10, 50}, {2, 1, 20, 40}, {3, 4, 30, 30}, {4, 3, 40, 20}, {5, 5, 50, 10}});
    BOOST_TEST(row.children == 5);
    BOOST_TEST(row.pairs == 5);
    // Differences of ranks 1, 1, 1, 1 and 0: 1 - 6 * 4 / (5 * 24).
    BOOST_TEST(row.heredity_fitness.value() == 0.8, tolerance(1e-12));
    BOOST_TEST(row.heredity_cells.value() == -1, tolerance(1e-12));
    // Ratios 2, 1/2, 4/3, 3/4, 1, of which the last alone is near 1.
    BOOST_TEST(row.kept_fitness.value() == 1);
    BOOST_TEST(row.near_mother.value() == 0.2);
    // 40/10, 20/20, 0, 20/40, 40/50.
    BOOST_TEST(row.cells_change.value() == 0.8);
}

BOOST_AUTO_TEST_CASE(equal_values_share_their_mean_rank) {
    // Ranks 1.5, 1.5, 3, 4 and 1, 2.5, 2.5, 4: 3.75 over the root of 4.5 * 4.5.
    const GenerationRow row = row_of({{1, 1}, {1, 2}, {2, 2}, {3, 3}});
    BOOST_TEST(row.heredity_fitness.value() == 3.75 / 4.5, tolerance(1e-12));
    // All have ten cells.
    BOOST_TEST(!row.heredity_cells.has_value());
    BOOST_TEST(row.cells_change.value() == 0);
}

BOOST_AUTO_TEST_CASE(a_child_without_fitness_keeps_nothing_and_makes_no_pair) {
    const GenerationRow row = row_of({{2, 2}, {2, 0}, {2, 0}, {2, 1.9}});
    BOOST_TEST(row.children == 4);
    BOOST_TEST(row.pairs == 2);
    BOOST_TEST(row.kept_fitness.value() == 0.475, tolerance(1e-12)); // of 0, 0, 0.95, 1
    BOOST_TEST(row.near_mother.value() == 0.5);
    BOOST_TEST(!row.heredity_fitness.has_value());
    BOOST_TEST(!row.heredity_cells.has_value());
    BOOST_TEST(!row.cells_change.has_value());
}

BOOST_AUTO_TEST_CASE(copies_and_children_of_mothers_without_fitness_do_not_count) {
    const Pair child{1, 1};
    for (const Origin copy : {Origin::champion, Origin::filler, Origin::clone}) {
        const GenerationRow row = row_of({child, child, child, {1, 1, 10, 10, copy}, {0, 1}});
        BOOST_TEST(row.children == 3);
        BOOST_TEST(row.pairs == 3);
    }
}

BOOST_AUTO_TEST_CASE(fewer_than_three_give_no_value) {
    const GenerationRow row = row_of({{1, 1}, {2, 2}, {1, 1, 10, 10, Origin::initial}});
    BOOST_TEST(row.children == 2);
    BOOST_TEST(row.pairs == 2);
    for (const Maybe &value :
         {row.heredity_fitness, row.heredity_cells, row.kept_fitness, row.near_mother, row.cells_change})
        BOOST_TEST(!value.has_value());
}

BOOST_AUTO_TEST_CASE(a_tenth_of_the_mothers_fitness_is_near) {
    const GenerationRow row = row_of({{10, 9}, {10, 11}, {10, 8.9}, {10, 11.2}});
    BOOST_TEST(row.near_mother.value() == 0.5);
}

BOOST_AUTO_TEST_CASE(every_value_is_finite_for_any_fitness) {
    constexpr double least = std::numeric_limits<double>::denorm_min(),
                     most = std::numeric_limits<double>::max();
    const GenerationRow row = row_of({{least, most, 0, 5}, {least, most, 0, 5}, {most, most, 0, 5}});
    BOOST_TEST(row.kept_fitness.value() == most);
    BOOST_TEST(row.near_mother.value() == 1.0 / 3);
    BOOST_TEST(row.cells_change.value() == 5);
}
