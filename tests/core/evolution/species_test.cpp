// SPDX-License-Identifier: MIT
#include "evolution/species.h"

#include "base/error.h"
#include "core/evolution/populations.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace planula;
using populations::with_weight;

namespace {

/// Two species represented by the weights 0 and 3, both empty; δ = 1.5 |Δw|, threshold 5.
Population waiting() {
    Population population = populations::of({{0}, {3}});
    for (auto &species : population.species) {
        species.members.clear();
        species.age = 9;
    }
    population.genomes.clear();
    return population;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_child_joins_the_first_compatible_species_in_list_order) {
    const NeatParameters parameters;
    Population population = waiting();
    for (const double weight : {5.0, 2.9, 3.0, -1.0}) // 2.9 and 3 are near the second, but the first is first
        add_child(parameters, population, with_weight(weight, population.innovations));
    BOOST_TEST(population.species[0].members == (std::vector<int>{1, 2, 3}),
               boost::test_tools::per_element());
    BOOST_TEST(population.species[1].members == (std::vector<int>{0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(a_distance_equal_to_the_threshold_is_compatible) {
    NeatParameters parameters;
    parameters.weight_coefficient = 1;
    Population population = waiting();
    add_child(parameters, population, with_weight(-5, population.innovations));
    BOOST_TEST(population.species.size() == 2u);
    BOOST_TEST(population.species[0].members.size() == 1u);
}

BOOST_AUTO_TEST_CASE(a_child_far_from_all_founds_a_species_at_the_end_and_represents_it) {
    const NeatParameters parameters;
    Population population = waiting();
    const std::int64_t first = population.next_genome;
    add_child(parameters, population, with_weight(-8, population.innovations));
    add_child(parameters, population, with_weight(-5, population.innovations));
    BOOST_REQUIRE(population.species.size() == 3u);
    const Species &founded = population.species[2];
    BOOST_TEST(founded.id == 2);
    BOOST_TEST(founded.age == 0);
    BOOST_TEST(founded.best_ever == 0);
    BOOST_TEST(!founded.best);
    BOOST_TEST(founded.representative.id == first);
    BOOST_TEST(founded.members.size() == 2u); // the second is too far from 0, but not from -8
    BOOST_TEST(population.next_species == 3);
}

BOOST_AUTO_TEST_CASE(representatives_do_not_change_before_the_generation_is_complete) {
    const NeatParameters parameters;
    Population population = waiting();
    add_child(parameters, population, with_weight(-3, population.innovations)); // 4.5 from 0
    add_child(parameters, population, with_weight(-6, population.innovations)); // 4.5 from -3, 9 from 0
    BOOST_TEST(population.species.size() == 3u);
    complete_generation(2, population);
    BOOST_REQUIRE(population.species.size() == 2u);
    BOOST_TEST(population.species[0].representative.links[0].weight == -3);
    BOOST_TEST(population.species[0].age == 9);
}

BOOST_AUTO_TEST_CASE(completing_a_generation_orders_slots_by_species_and_drops_the_empty) {
    const NeatParameters parameters;
    Population population = populations::of({{0}, {7}, {3}});
    for (auto &species : population.species) species.members.clear();
    population.genomes.clear();
    for (const double weight : {5.0, 1.0, 6.0, 2.0})
        add_child(parameters, population, with_weight(weight, population.innovations));
    population.species[1].representative.links[0].weight = 1000;
    complete_generation(4, population);
    std::vector<double> weights;
    for (const auto &genome : population.genomes) weights.push_back(genome.links[0].weight);
    BOOST_TEST(weights == (std::vector<double>{1, 2, 5, 6}), boost::test_tools::per_element());
    BOOST_TEST(population.species.size() == 2u);
    BOOST_TEST(population.species[1].members == (std::vector<int>{2, 3}), boost::test_tools::per_element());
    BOOST_TEST(population.species[1].representative.links[0].weight == 5);
}

BOOST_AUTO_TEST_CASE(a_deficit_is_filled_with_copies_of_the_first_species_first_member) {
    const NeatParameters parameters;
    Population population = waiting();
    for (const double weight : {5.0, 1.0, 2.0})
        add_child(parameters, population, with_weight(weight, population.innovations));
    const std::int64_t first = population.genomes[1].id, next = population.next_genome;
    complete_generation(5, population);
    BOOST_REQUIRE(population.genomes.size() == 5u);
    BOOST_TEST(populations::sizes(population) == (std::vector<int>{4, 1}), boost::test_tools::per_element());
    for (const int slot : {2, 3}) {
        const Genome &filler = population.genomes[slot];
        BOOST_TEST((filler.origin == Origin::filler));
        BOOST_TEST(filler.mother == first);
        BOOST_TEST(filler.id == next + slot - 2);
        BOOST_TEST(filler.links[0].weight == 1);
    }
}

BOOST_AUTO_TEST_CASE(no_children_or_too_many_are_an_internal_error) {
    const NeatParameters parameters;
    Population population = waiting();
    BOOST_CHECK_THROW(complete_generation(2, population), InternalError);
    for (int i = 0; i < 3; ++i) add_child(parameters, population, with_weight(0, population.innovations));
    BOOST_CHECK_THROW(complete_generation(2, population), InternalError);
}
