// SPDX-License-Identifier: MIT
#include "genome/distance.h"

#include "base/random.h"
#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <vector>

using namespace planula;
using specimens::linked;

BOOST_AUTO_TEST_CASE(distance_counts_links_and_averages_weights_and_ignores_size) {
    const NeatParameters parameters;
    // Matching 1 and 4 with |Δw| 0.5 and 1.5; disjoint 2 and 3; excess 7 and 8: 4 + 1.5 · 1.
    const Genome a = linked({{1, 1}, {2, 9}, {4, -1}}),
                 b = linked({{1, 0.5}, {3, 9}, {4, 0.5}, {7, 9}, {8, 9}});
    BOOST_TEST(distance(a, b, parameters) == 5.5);
    BOOST_TEST(distance(b, a, parameters) == 5.5);
    BOOST_TEST(distance(a, a, parameters) == 0);

    // Twenty further equal links only dilute the mean difference of weights.
    Genome large_a = a, large_b = b;
    for (int i = 10; i < 30; ++i) {
        large_a.links.push_back({i, i, 40, 1, false});
        large_b.links.push_back({i, i, 40, 1, false});
    }
    BOOST_TEST(distance(large_a, large_b, parameters) == 4 + 1.5 * (2.0 / 22));
}

BOOST_AUTO_TEST_CASE(each_coefficient_weighs_its_own_part) {
    const Genome a = linked({{1, 1}, {2, 9}, {4, -1}}), b = linked({{1, 0.5}, {3, 9}, {4, 0.5}, {7, 9}});
    NeatParameters parameters;
    parameters.disjoint_coefficient = 10;
    parameters.excess_coefficient = 100;
    parameters.weight_coefficient = 0.25;
    BOOST_TEST(distance(a, b, parameters) == 100 + 20 + 0.25);
}

BOOST_AUTO_TEST_CASE(genomes_without_common_links_differ_by_their_links_alone) {
    const NeatParameters parameters;
    BOOST_TEST(distance(linked({}), linked({}), parameters) == 0);
    BOOST_TEST(distance(linked({{0, 5}, {1, 5}}), linked({}), parameters) == 2);
    BOOST_TEST(distance(linked({{0, 5}}), linked({{1, 5}}), parameters) == 2);
}

BOOST_AUTO_TEST_CASE(sums_over_many_are_those_of_pairs_to_the_bit) {
    NeatParameters parameters;
    parameters.disjoint_coefficient = 0.7;
    parameters.excess_coefficient = 1.3;
    Stream stream(1, 0, 0, Purpose::sampling);
    std::vector<Genome> genomes{linked({}), linked({{40, 1}}), linked({})};
    while (genomes.size() < 30) {
        genomes.push_back(linked({}));
        for (int innovation = 0; innovation < 25; ++innovation)
            if (stream.uniform() < 0.5)
                genomes.back().links.push_back({innovation, innovation, 40, stream.uniform(), false});
    }
    std::vector<const Genome *> all;
    for (const Genome &genome : genomes) all.push_back(&genome);

    std::vector<double> sums;
    for (std::size_t a = 0; a < genomes.size(); ++a) {
        sums.push_back(0);
        for (std::size_t b = 0; b < genomes.size(); ++b)
            if (b != a) sums.back() += distance(genomes[a], genomes[b], parameters);
    }
    BOOST_TEST(distance_sums(all, parameters) == sums, boost::test_tools::per_element());
    BOOST_TEST(distance_sums({}, parameters).empty());
}

BOOST_AUTO_TEST_CASE(a_clone_is_nearer_than_the_clone_distance_to_any_sibling) {
    const NeatParameters parameters;
    const std::vector<Genome> siblings{linked({{0, 1}, {1, 1}}), linked({{0, 2}, {1, 2}})};
    BOOST_TEST(is_clone(linked({{0, 2}, {1, 2}}), siblings, parameters));
    BOOST_TEST(is_clone(linked({{0, 2}, {1, 2 + 1e-5}}), siblings, parameters)); // δ = 0.75e-5
    BOOST_TEST(!is_clone(linked({{0, 2}, {1, 2 + 2e-5}}), siblings, parameters));
    BOOST_TEST(!is_clone(linked({{0, 2}}), siblings, parameters));
    BOOST_TEST(!is_clone(linked({{0, 2}, {1, 2}}), {}, parameters));
}

BOOST_AUTO_TEST_CASE(a_clone_has_as_many_links_even_where_links_cost_nothing) {
    NeatParameters parameters;
    parameters.disjoint_coefficient = parameters.excess_coefficient = 0;
    const std::vector<Genome> siblings{linked({{0, 1}, {1, 1}})};
    BOOST_TEST(!is_clone(linked({{0, 1}}), siblings, parameters));
    BOOST_TEST(is_clone(linked({{0, 1}, {2, 5}}), siblings, parameters));
}
