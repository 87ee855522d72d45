// SPDX-License-Identifier: MIT
#include "network/network.h"

#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <cmath>

using namespace planula;
using specimens::add_link;

namespace {

/// One input, the bias, one output (node 2), and a hidden node 3.
Genome with_hidden() {
    Genome genome = specimens::bare_genome(2, 1);
    genome.nodes.push_back({3, NodeKind::hidden, 0.5});
    return genome;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_node_is_tanh_of_the_weighted_sum_of_its_sources) {
    Genome genome = specimens::bare_genome(2, 1);
    add_link(genome, 0, 2, 0.5);
    add_link(genome, 1, 2, -0.25);
    const Network network = express(genome, 16);
    BOOST_TEST(network.depth == 1);
    std::vector<double> activations{0.8, 1, 99};
    evaluate(network, activations);
    BOOST_TEST(activations[2] == 0.14888503362331795, boost::test_tools::tolerance(1e-15)); // tanh 0.15
}

BOOST_AUTO_TEST_CASE(a_feed_forward_network_runs_as_many_steps_as_it_is_deep_and_forgets) {
    Genome genome = with_hidden();
    add_link(genome, 0, 3, 2);
    add_link(genome, 3, 2, 1);
    const Network network = express(genome, 16);
    BOOST_TEST(network.depth == 2);
    for (const double old : {0.0, 0.7}) {
        std::vector<double> activations{0.3, 1, old, old};
        evaluate(network, activations);
        BOOST_TEST(activations[3] == std::tanh(0.6), boost::test_tools::tolerance(1e-15));
        BOOST_TEST(activations[2] == std::tanh(std::tanh(0.6)), boost::test_tools::tolerance(1e-15));
    }
}

BOOST_AUTO_TEST_CASE(one_step_carries_signals_one_link_far) {
    Genome genome = with_hidden();
    add_link(genome, 0, 3, 2);
    add_link(genome, 3, 2, 1);
    const Network network = express(genome, 16);
    std::vector<double> activations{0.3, 1, 0, 0};
    step(network, activations);
    BOOST_TEST(activations[2] == 0);
    BOOST_TEST(activations[3] == std::tanh(0.6), boost::test_tools::tolerance(1e-15));
    step(network, activations);
    BOOST_TEST(activations[2] == std::tanh(std::tanh(0.6)), boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_loop_reads_its_own_old_activation) {
    Genome genome = specimens::bare_genome(1, 1);
    add_link(genome, 1, 1, -3);
    const Network network = express(genome, 16);
    std::vector<double> activations{1, 0.5};
    step(network, activations);
    BOOST_TEST(activations[1] == std::tanh(-1.5), boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(depth_is_the_longest_path_to_an_output_and_capped) {
    // 0 → 2 directly, and 0 → 3 → 4 → 2; 5 hangs behind 4 and leads nowhere.
    Genome genome = with_hidden();
    genome.nodes.push_back({4, NodeKind::hidden, 0.75});
    genome.nodes.push_back({5, NodeKind::hidden, 0.9});
    add_link(genome, 0, 2, 1);
    add_link(genome, 0, 3, 1);
    add_link(genome, 3, 4, 1);
    add_link(genome, 4, 2, 1);
    add_link(genome, 4, 5, 1);
    BOOST_TEST(express(genome, 16).depth == 3);
    BOOST_TEST(express(genome, 2).depth == 2);
    add_link(genome, 2, 3, 1); // a cycle
    BOOST_TEST(express(genome, 16).depth == 16);
}

BOOST_AUTO_TEST_CASE(an_output_without_links_is_silent) {
    const Network network = express(specimens::bare_genome(2, 1), 16);
    BOOST_TEST(network.depth == 0);
    std::vector<double> activations{1, 1, 0.5};
    evaluate(network, activations);
    BOOST_TEST(activations[2] == 0);
}
