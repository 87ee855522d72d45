// SPDX-License-Identifier: MIT
#include "genome/cross.h"

#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>
#include <vector>

using namespace planula;
using specimens::linked;

namespace {

Genome named(Genome genome, std::int64_t id) {
    genome.id = id;
    return genome;
}

/// Mother 1,2,4 and father 1,3,4,7 with matching weights ±1.
const Genome mother = named(linked({{1, 1}, {2, 5}, {4, 1}}), 10);
const Genome father = named(linked({{1, -1}, {3, 6}, {4, -1}, {7, 6}}), 20);

std::vector<int> innovations_of(const Genome &genome) {
    std::vector<int> result;
    for (const auto &link : genome.links) result.push_back(link.innovation);
    return result;
}

} // namespace

BOOST_AUTO_TEST_CASE(disjoint_and_excess_links_come_from_the_fitter_parent) {
    Stream stream = specimens::stream(1);
    const std::vector<int> of_mother{1, 2, 4}, of_father{1, 3, 4, 7};
    BOOST_TEST((innovations_of(cross({mother, 2}, {father, 1}, {}, stream)) == of_mother));
    BOOST_TEST((innovations_of(cross({mother, 1}, {father, 2}, {}, stream)) == of_father));
    // Of equals the shorter, whichever side it is on.
    BOOST_TEST((innovations_of(cross({mother, 1}, {father, 1}, {}, stream)) == of_mother));
    BOOST_TEST((innovations_of(cross({father, 1}, {mother, 1}, {}, stream)) == of_mother));
}

BOOST_AUTO_TEST_CASE(a_coin_decides_between_equals_of_one_length) {
    const Genome a = linked({{1, 1}, {2, 1}}), b = linked({{1, 1}, {3, 1}});
    int of_a = 0;
    for (int n = 0; n < 2000; ++n) {
        Stream stream = specimens::stream(n);
        of_a += innovations_of(cross({a, 1}, {b, 1}, {}, stream))[1] == 2;
    }
    BOOST_TEST(std::abs(of_a - 1000) < 120);
}

BOOST_AUTO_TEST_CASE(matching_links_are_chosen_one_by_one_with_equal_chances) {
    int first = 0, equal = 0;
    for (int n = 0; n < 4000; ++n) {
        Stream stream = specimens::stream(n);
        const Genome child = cross({mother, 2}, {father, 1}, {}, stream);
        BOOST_REQUIRE(std::abs(child.links[0].weight) == 1);
        first += child.links[0].weight == 1;
        equal += child.links[0].weight == child.links[2].weight;
    }
    BOOST_TEST(std::abs(first - 2000) < 160);
    BOOST_TEST(std::abs(equal - 2000) < 160);
}

BOOST_AUTO_TEST_CASE(averaging_takes_the_mean_of_matching_weights_only) {
    Stream stream = specimens::stream(2);
    const Genome a = linked({{1, 1}, {2, 5}}), b = linked({{1, 0.5}, {2, -5}, {3, 7}});
    const Genome child = cross({a, 1}, {b, 2}, {true, false}, stream);
    BOOST_TEST(child.links[0].weight == 0.75);
    BOOST_TEST(child.links[1].weight == 0);
    BOOST_TEST(child.links[2].weight == 7);
    const Genome rounded = cross({a, 1}, {b, 2}, {true, false, 0.5}, stream);
    BOOST_TEST(rounded.links[0].weight == 1); // 0.75, of two multiples the higher
}

BOOST_AUTO_TEST_CASE(between_species_all_links_of_both_are_kept) {
    Stream stream = specimens::stream(3);
    const std::vector<int> all{1, 2, 3, 4, 7};
    BOOST_TEST((innovations_of(cross({mother, 2}, {father, 1}, {false, true}, stream)) == all));
}

BOOST_AUTO_TEST_CASE(the_child_has_the_nodes_its_links_need_and_no_others) {
    Genome a = specimens::bare(2, 1), b = a;
    a.nodes.push_back({3, NodeKind::hidden, 0.5});
    b.nodes.push_back({4, NodeKind::hidden, 0.25});
    a.links = {{1, 0, 3, 1, false}, {2, 3, 2, 1, false}};
    b.links = {{3, 0, 4, 1, false}, {4, 4, 2, 1, false}, {5, 0, 2, 1, false}};
    Stream stream = specimens::stream(4);
    const Genome like_a = cross({a, 2}, {b, 1}, {}, stream);
    BOOST_TEST(like_a.hidden() == 1);
    BOOST_TEST((like_a.nodes == a.nodes));
    const Genome like_b = cross({a, 1}, {b, 2}, {}, stream);
    BOOST_TEST((like_b.nodes == b.nodes));
    const Genome both = cross({a, 1}, {b, 2}, {false, true}, stream);
    BOOST_TEST(both.hidden() == 2);
    BOOST_CHECK_NO_THROW(check_genome(both));
}

BOOST_AUTO_TEST_CASE(a_child_has_the_ids_of_its_parents) {
    Stream stream = specimens::stream(5);
    const Genome child = cross({mother, 2}, {father, 1}, {}, stream);
    BOOST_TEST(child.mother == 10);
    BOOST_TEST(child.father == 20);
    BOOST_TEST((child.origin == Origin::crossover));
    BOOST_TEST(child.inputs == mother.inputs);
    BOOST_TEST(child.outputs == mother.outputs);
}

BOOST_AUTO_TEST_CASE(crossing_random_genomes_keeps_every_invariant) {
    for (const bool recurrent : {false, true}) {
        Innovations innovations;
        const Genome ancestor = specimens::connected(4, 3, innovations);
        std::vector<Genome> pool(60, ancestor);
        Stream stream = specimens::stream(6);
        for (auto &genome : pool)
            for (int step = 0; step < 25; ++step)
                mutate(specimens::structural(), recurrent, innovations, stream, genome);
        for (const auto &a : pool)
            for (const auto &b : pool) {
                const Crossing crossing{stream.chance(0.5), stream.chance(0.5)};
                const Genome child = cross({a, 1}, {b, 1}, crossing, stream);
                BOOST_REQUIRE_NO_THROW(check_genome(child));
                BOOST_REQUIRE(recurrent || specimens::climbs(child));
                BOOST_REQUIRE(crossing.interspecies || !has_dead_ends(child));
            }
    }
}
