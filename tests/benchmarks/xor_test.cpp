// SPDX-License-Identifier: MIT
#include "benchmarks/xor.h"

#include "benchmarks/settings.h"
#include "benchmarks/solve.h"
#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

using namespace planula;
using namespace planula::benchmark;

namespace {

/// tanh units for "a or b" and "a and b"; the output is the first without the second.
Genome exclusive_or() {
    Genome genome = specimens::bare(3, 1);
    genome.nodes.push_back({4, NodeKind::hidden, 0.5});
    genome.nodes.push_back({5, NodeKind::hidden, 0.5});
    genome.links = {{0, 0, 4, 8, false}, {1, 1, 4, 8, false},  {2, 2, 4, -4, false},
                    {3, 0, 5, 8, false}, {4, 1, 5, 8, false},  {5, 2, 5, -12, false},
                    {6, 4, 3, 4, false}, {7, 5, 3, -4, false}, {8, 2, 3, -4, false}};
    return genome;
}

} // namespace

BOOST_AUTO_TEST_CASE(fitness_is_the_square_of_four_minus_the_error) {
    const auto constant = [](double value) {
        return attempt_xor([=](std::span<const double>, std::span<double> out) { out[0] = value; });
    };
    BOOST_TEST(constant(0).fitness == 4);  // one half everywhere: error 2
    BOOST_TEST(constant(-1).fitness == 4); // right for two cases, wrong for two
    BOOST_TEST(!constant(0).solved);
    BOOST_TEST(!constant(-1).solved);
    const Attempt perfect = attempt_xor([](std::span<const double> in, std::span<double> out) {
        BOOST_TEST(in[2] == 1);
        out[0] = in[0] != in[1] ? 1 : -1;
    });
    BOOST_TEST(perfect.fitness == 16);
    BOOST_TEST(perfect.solved);
    BOOST_TEST(perfect.behaviour == (std::vector<double>{0, 1, 1, 0}), boost::test_tools::per_element());
}

BOOST_AUTO_TEST_CASE(one_output_on_the_wrong_side_is_not_a_solution) {
    const Attempt attempt = attempt_xor([](std::span<const double> in, std::span<double> out) {
        out[0] = in[0] != in[1] ? 1 : in[0] + in[1] == 2 ? 0.01 : -1;
    });
    BOOST_TEST(!attempt.solved);
    BOOST_TEST(attempt.fitness > 12); // though nearly as good as any
}

BOOST_AUTO_TEST_CASE(a_network_with_two_hidden_nodes_solves_it_and_one_without_cannot) {
    BOOST_TEST(xor_task().attempt(exclusive_or()).solved);
    Innovations innovations;
    const Genome line = specimens::connected(3, 1, innovations);
    for (const double a : {-4.0, 1.0, 4.0})
        for (const double b : {-4.0, 1.0, 4.0})
            for (const double bias : {-4.0, 0.0, 4.0}) {
                Genome genome = line;
                genome.links[0].weight = a, genome.links[1].weight = b, genome.links[2].weight = bias;
                BOOST_TEST(!xor_task().attempt(genome).solved);
            }
}

BOOST_AUTO_TEST_CASE(evolution_solves_it_every_time) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Solution own = solve(xor_task(), "neat", stanley_settings(false).parameters, seed, 100);
        BOOST_TEST(own.solved);
        const Solution paper = solve(xor_task(), "neat", multineat_settings().parameters, seed, 150);
        BOOST_TEST(paper.solved);
    }
}
