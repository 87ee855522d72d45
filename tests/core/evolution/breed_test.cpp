// SPDX-License-Identifier: MIT
#include "evolution/breed.h"

#include "core/evolution/populations.h"
#include "genome/distance.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <set>
#include <vector>

using namespace planula;

namespace {

/// Parents whose scores fall from slot to slot, so that members are in order.
struct Family {
    explicit Family(Population p) : population(std::move(p)) {
        for (std::size_t i = 0; i < population.genomes.size(); ++i)
            scores.push_back(100 - static_cast<double>(i));
    }
    Parents parents() const { return {population.genomes, scores, population.species}; }
    Genome child(int n, const NeatParameters &parameters, std::span<const Genome> siblings = {},
                 bool recurrent = false, int species = 0) {
        Stream stream = specimens::stream(n);
        return breed(parents(), population.species[species], siblings, recurrent, parameters,
                     population.innovations, stream);
    }
    Population population;
    std::vector<double> scores;
};

/// A species of `size` members with different weights.
Family family(int size) {
    std::vector<double> weights;
    for (int i = 0; i < size; ++i) weights.push_back(0.25 * i);
    return Family(populations::of({weights}));
}

std::set<std::int64_t> mothers_of(Family &family, int children) {
    std::set<std::int64_t> mothers;
    for (int n = 0; n < children; ++n) mothers.insert(family.child(n, NeatParameters()).mother);
    return mothers;
}

} // namespace

BOOST_AUTO_TEST_CASE(parents_are_the_best_quarter_and_one_or_two_more) {
    // Indices 0 … min(n − 1, ⌊0.25 n + 1⌋), inclusive.
    for (const auto &[size, last] : {std::pair{1, 0}, {2, 1}, {3, 1}, {4, 2}, {7, 2}, {8, 3}, {20, 6}}) {
        Family some = family(size);
        const auto mothers = mothers_of(some, 400);
        BOOST_TEST(mothers.size() == static_cast<std::size_t>(last) + 1);
        BOOST_TEST(*mothers.rbegin() == last);
    }
}

BOOST_AUTO_TEST_CASE(children_come_in_the_shares_asked_for) {
    Family some = family(40);
    int crossed = 0, crossed_and_mutated = 0, mutated = 0;
    for (int n = 0; n < 8000; ++n) {
        const Genome child = some.child(n, NeatParameters());
        crossed += child.origin == Origin::crossover;
        crossed_and_mutated += child.origin == Origin::crossover_mutation;
        mutated += child.origin == Origin::mutation;
        BOOST_REQUIRE((child.father >= 0) == (child.origin != Origin::mutation));
        BOOST_REQUIRE(child.father != child.mother);
    }
    BOOST_TEST(crossed + crossed_and_mutated + mutated == 8000);
    BOOST_TEST(std::abs(mutated - 2000) < 200);             // 1 − 0.75, always mutated
    BOOST_TEST(std::abs(crossed_and_mutated - 1500) < 180); // 0.75 · 0.25
}

BOOST_AUTO_TEST_CASE(a_quarter_of_crossovers_averages) {
    NeatParameters parameters;
    parameters.crossover_rate = 1;
    parameters.mutation_rate = 0;
    Family pair(populations::of({{-1, 1}}));
    int averaged = 0;
    for (int n = 0; n < 4000; ++n) averaged += pair.child(n, parameters).links[0].weight == 0;
    BOOST_TEST(std::abs(averaged - 1000) < 140);
}

BOOST_AUTO_TEST_CASE(a_species_of_one_only_mutates) {
    NeatParameters parameters;
    parameters.crossover_rate = 1;
    parameters.mutation_rate = 0;
    Family loner(populations::of({{2}, {3, 4}}));
    for (int n = 0; n < 200; ++n) {
        const Genome child = loner.child(n, parameters);
        BOOST_TEST((child.origin == Origin::mutation));
        BOOST_TEST((child.links != loner.population.genomes[0].links));
    }
}

BOOST_AUTO_TEST_CASE(a_father_like_the_mother_is_redrawn_and_mating_with_oneself_changes_nothing) {
    NeatParameters parameters;
    parameters.crossover_rate = 1;
    parameters.mutation_rate = 0;
    // Slots 0 and 1 are as good as equal, 2 differs: a mother of the first two always takes 2.
    Family three(populations::of({{1, 1 + 1e-7, 3, 9}}));
    for (int n = 0; n < 500; ++n) {
        const Genome child = three.child(n, parameters);
        BOOST_TEST((child.mother == 2 ? child.father != 2 : child.father == 2));
    }

    // Without redraws one in three mates with itself.
    parameters.mate_tries = 0;
    int alone = 0;
    for (int n = 0; n < 900; ++n) {
        const Genome child = three.child(n, parameters);
        if (child.father != -1) continue;
        ++alone;
        BOOST_TEST((child.origin == Origin::clone));
        BOOST_TEST((child.links == three.population.genomes[child.mother].links));
    }
    BOOST_TEST(std::abs(alone - 300) < 75);
}

BOOST_AUTO_TEST_CASE(fathers_of_other_species_are_rare_and_bring_all_their_links) {
    Population population = populations::of({{1, 2}, {5, 6}});
    Innovations &innovations = population.innovations;
    for (auto &genome : population.genomes) // the second species has a link of its own
        if (genome.links[0].weight > 4) genome.links.push_back({innovations.link(1, 2), 1, 2, 1, false});
    Family two(population);
    NeatParameters parameters;
    parameters.crossover_rate = 1;
    parameters.mutation_rate = 0;
    for (int n = 0; n < 500; ++n) BOOST_TEST(two.child(n, parameters).father < 2); // 1e-4

    parameters.interspecies_rate = 1;
    int foreign = 0;
    for (int n = 0; n < 2000; ++n) {
        const Genome child = two.child(n, parameters);
        foreign += child.father >= 2;
        BOOST_TEST(child.links.size() == (child.father >= 2 ? 2u : 1u)); // though the mother is fitter
    }
    BOOST_TEST(std::abs(foreign - 1000) < 120); // the own species is drawn as often
}

BOOST_AUTO_TEST_CASE(a_clone_is_tried_again_with_nothing_but_other_weights) {
    // Splitting the only link gives the same genome each time: the second child must differ otherwise.
    NeatParameters parameters;
    parameters.add_node_rate = 1;
    parameters.add_link_rate = parameters.remove_link_rate = parameters.mutate_weights_rate = 0;
    Family loner(populations::of({{2}}));
    const Genome first = loner.child(1, parameters);
    BOOST_TEST(first.hidden() == 1);
    for (int n = 2; n < 50; ++n) {
        const std::vector<Genome> siblings{loner.population.genomes[0], first};
        const Genome second = loner.child(n, parameters, siblings);
        BOOST_TEST(second.hidden() == 0);
        BOOST_TEST(second.links[0].weight != 2);
    }

    // Where weights cannot change either, the last try is kept.
    parameters.weight_power = parameters.weight_severe_rate = 0;
    const std::vector<Genome> siblings{loner.population.genomes[0], first};
    BOOST_TEST((loner.child(2, parameters, siblings).links == loner.population.genomes[0].links));
    parameters.clone_tries = 1;
    BOOST_TEST(loner.child(2, parameters, siblings).hidden() == 1);
}

BOOST_AUTO_TEST_CASE(children_differ_from_all_their_siblings) {
    Family some = family(6);
    std::vector<Genome> siblings;
    for (int n = 0; n < 200; ++n) {
        const Genome child = some.child(n, NeatParameters(), siblings);
        BOOST_TEST(!is_clone(child, siblings, NeatParameters()));
        siblings.push_back(child);
    }
}

BOOST_AUTO_TEST_CASE(a_child_with_dead_ends_is_replaced_by_an_unchanged_parent) {
    // The only link to add runs back from the output, which then has one way in and one out.
    Population population = populations::of({{1, 2, 3}});
    for (auto &genome : population.genomes) {
        Innovations &innovations = population.innovations;
        genome.nodes.push_back({3, NodeKind::hidden, 0.5});
        const double weight = genome.links[0].weight;
        genome.links = {{innovations.link(0, 3), 0, 3, weight, false},
                        {innovations.link(3, 2), 3, 2, weight, false}};
    }
    Family some(population);
    NeatParameters parameters;
    parameters.crossover_rate = 0;
    parameters.add_link_rate = 1;
    parameters.add_node_rate = parameters.remove_link_rate = parameters.mutate_weights_rate = 0;
    parameters.recurrent_rate = 1;
    parameters.loop_rate = 0;
    for (int n = 0; n < 100; ++n) {
        const Genome child = some.child(n, parameters, {}, true);
        BOOST_TEST((child.origin == Origin::clone));
        BOOST_TEST(child.father == -1);
        BOOST_TEST(child.mother < 2);
        BOOST_TEST((child.links == population.genomes[child.mother].links));
    }
}

BOOST_AUTO_TEST_CASE(the_champion_is_the_first_member) {
    const Family some = family(3);
    const Genome champion = copy_champion(some.parents(), some.population.species[0]);
    BOOST_TEST((champion.links == some.population.genomes[0].links));
    BOOST_TEST(champion.mother == 0);
    BOOST_TEST((champion.origin == Origin::champion));
}
