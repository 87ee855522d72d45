// SPDX-License-Identifier: MIT
#include "network/network.h"

#include "base/lane_sets.h"
#include "base/math.h"
#include "base/random.h"
#include "support/specimens.h"

#include <boost/test/unit_test.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

using namespace planula;
using specimens::add_link;

namespace {

/// One input, the bias, one output (node 2), and a hidden node 3.
Genome with_hidden() {
    Genome genome = specimens::bare_genome(2, 1);
    genome.nodes.push_back({3, NodeKind::hidden, 0.5});
    return genome;
}

/// The activations of one cell.
Activations one_cell(const std::vector<double> &values) {
    Activations result(static_cast<int>(values.size()), 1);
    for (std::size_t i = 0; i < values.size(); ++i) result.at(0, static_cast<int>(i)) = values[i];
    return result;
}

/// So many hidden nodes, and links from anywhere to anything that is no input; some weights are huge.
Genome random_network(Stream &stream, int hidden, int links) {
    Genome genome = specimens::bare_genome(2 + hidden % 3, 1 + hidden % 2);
    for (int i = 0; i < hidden; ++i)
        genome.nodes.push_back({static_cast<int>(genome.nodes.size()), NodeKind::hidden, 0.5});
    const int nodes = static_cast<int>(genome.nodes.size());
    for (int i = 0; i < links; ++i) {
        const int from = stream.below(nodes);
        const int to = genome.inputs + stream.below(nodes - genome.inputs);
        add_link(genome, from, to, (i % 7 == 0 ? 1e3 : 3) * stream.triangular());
    }
    return genome;
}

/// One step of one cell, as the model says it.
std::vector<double> stepped(const Network &network, const std::vector<double> &old) {
    std::vector<double> result = old;
    for (int target = network.inputs; target < network.nodes; ++target) {
        double sum = 0;
        const int row = target - network.inputs;
        for (int s = network.first_source[row]; s < network.first_source[row + 1]; ++s)
            sum += network.sources[s].weight * old[network.sources[s].node];
        result[target] = math::tanh(sum);
    }
    return result;
}

std::uint64_t bits(double x) { return std::bit_cast<std::uint64_t>(x); }

/// Calls `action` with each width of lanes that this processor has.
template <class Action> void with_all_lanes(const Action &action) {
    const std::string_view widest = name_of(chosen_lanes());
    for (const LaneSet lanes : lane_sets()) {
        choose_lanes(name_of(lanes));
        action(name_of(lanes));
    }
    choose_lanes(widest);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_node_is_tanh_of_the_weighted_sum_of_its_sources) {
    Genome genome = specimens::bare_genome(2, 1);
    add_link(genome, 0, 2, 0.5);
    add_link(genome, 1, 2, -0.25);
    const Network network = express(genome, 16);
    BOOST_TEST(network.depth == 1);
    Activations activations = one_cell({0.8, 1, 99});
    evaluate(network, activations);
    BOOST_TEST(activations.at(0, 2) == 0.14888503362331795, boost::test_tools::tolerance(1e-15)); // tanh 0.15
}

BOOST_AUTO_TEST_CASE(a_feed_forward_network_runs_as_many_steps_as_it_is_deep_and_keeps_no_state) {
    Genome genome = with_hidden();
    add_link(genome, 0, 3, 2);
    add_link(genome, 3, 2, 1);
    const Network network = express(genome, 16);
    BOOST_TEST(network.depth == 2);
    for (const double old : {0.0, 0.7}) {
        Activations activations = one_cell({0.3, 1, old, old});
        evaluate(network, activations);
        BOOST_TEST(activations.at(0, 3) == std::tanh(0.6), boost::test_tools::tolerance(1e-15));
        BOOST_TEST(activations.at(0, 2) == std::tanh(std::tanh(0.6)), boost::test_tools::tolerance(1e-15));
    }
}

BOOST_AUTO_TEST_CASE(one_step_carries_signals_one_link_far) {
    Genome genome = with_hidden();
    add_link(genome, 0, 3, 2);
    add_link(genome, 3, 2, 1);
    const Network network = express(genome, 16);
    Activations activations = one_cell({0.3, 1, 0, 0});
    step(network, activations);
    BOOST_TEST(activations.at(0, 2) == 0);
    BOOST_TEST(activations.at(0, 3) == std::tanh(0.6), boost::test_tools::tolerance(1e-15));
    step(network, activations);
    BOOST_TEST(activations.at(0, 2) == std::tanh(std::tanh(0.6)), boost::test_tools::tolerance(1e-15));
}

BOOST_AUTO_TEST_CASE(a_loop_reads_its_own_old_activation) {
    Genome genome = specimens::bare_genome(1, 1);
    add_link(genome, 1, 1, -3);
    const Network network = express(genome, 16);
    Activations activations = one_cell({1, 0.5});
    step(network, activations);
    BOOST_TEST(activations.at(0, 1) == std::tanh(-1.5), boost::test_tools::tolerance(1e-15));
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

BOOST_AUTO_TEST_CASE(an_output_without_links_is_zero) {
    const Network network = express(specimens::bare_genome(2, 1), 16);
    BOOST_TEST(network.depth == 0);
    Activations activations = one_cell({1, 1, 0.5});
    evaluate(network, activations);
    BOOST_TEST(activations.at(0, 2) == 0);
}

BOOST_AUTO_TEST_CASE(many_cells_side_by_side_do_what_each_would_alone_at_any_width) {
    // Random recurrent networks of all sizes in 1 to 33 cells: five steps, and an evaluation.
    with_all_lanes([](std::string_view lanes) {
        Stream stream(11, 0, 0, Purpose::sampling);
        for (int hidden = 0; hidden < 40; ++hidden) {
            const Network network = express(random_network(stream, hidden, 3 * hidden + hidden % 5), 16);
            const int cells = 1 + (hidden * 7) % 33;
            std::vector<std::vector<double>> each(cells, std::vector<double>(network.nodes));
            Activations all(network.nodes, cells);
            for (int cell = 0; cell < cells; ++cell)
                for (int node = 0; node < network.nodes; ++node)
                    all.at(cell, node) = each[cell][node] = stream.triangular();
            const auto are_equal = [&] {
                bool equal = true;
                for (int cell = 0; cell < cells; ++cell)
                    for (int node = 0; node < network.nodes; ++node)
                        equal = equal && bits(all.at(cell, node)) == bits(each[cell][node]);
                return equal;
            };
            for (int i = 0; i < 5; ++i) {
                BOOST_TEST(step(network, all));
                for (auto &old : each) old = stepped(network, old);
            }
            BOOST_TEST(are_equal(),
                       lanes << ": steps of " << network.nodes << " nodes, " << cells << " cells");

            evaluate(network, all);
            for (auto &old : each) {
                std::fill(old.begin() + network.inputs, old.end(), 0.0);
                for (int i = 0; i < network.depth; ++i) old = stepped(network, old);
            }
            BOOST_TEST(are_equal(), lanes << ": evaluation of " << network.nodes << " nodes");
        }
    });
}

BOOST_AUTO_TEST_CASE(the_tanh_of_every_lane_has_the_bits_of_the_one_number) {
    // One link of weight 1: its target's sum is 0 + x.
    Genome genome = specimens::bare_genome(1, 1);
    add_link(genome, 0, 1, 1);
    const Network network = express(genome, 16);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::vector<double> numbers{0.0,
                                5e-324,
                                1e-310,
                                0x1p-1022,
                                20,
                                19.999999999999996,
                                20.000000000000004,
                                0.35,
                                710,
                                1e300,
                                infinity,
                                std::numeric_limits<double>::max()};
    for (double x = 1e-320; x < 50; x *= 1.037) numbers.push_back(x);
    for (double x = 0; x < 21; x += 0x1p-9) numbers.push_back(x);
    Stream stream(12, 0, 0, Purpose::sampling);
    for (int i = 0; i < 20000; ++i) numbers.push_back(25 * stream.triangular());
    for (std::size_t i = 0, end = numbers.size(); i < end; ++i) numbers.push_back(-numbers[i]);

    const int cells = static_cast<int>(numbers.size());
    with_all_lanes([&](std::string_view lanes) {
        Activations activations(2, cells);
        for (int i = 0; i < cells; ++i) activations.at(i, 0) = numbers[i];
        BOOST_TEST(step(network, activations));
        int different = 0;
        for (int i = 0; i < cells; ++i)
            different += bits(activations.at(i, 1)) != bits(math::tanh(0.0 + numbers[i]));
        BOOST_TEST(different == 0, lanes << ": " << different << " of " << cells);
    });
}

BOOST_AUTO_TEST_CASE(an_activation_that_is_not_a_number_is_reported_and_other_cells_are_unaffected) {
    Genome genome = specimens::bare_genome(1, 1);
    add_link(genome, 0, 1, 1);
    const Network network = express(genome, 16);
    with_all_lanes([&](std::string_view lanes) {
        for (int cells = 1; cells <= 17; ++cells)
            for (int sick = 0; sick < cells; ++sick) {
                Activations activations(2, cells);
                BOOST_TEST(step(network, activations), lanes);
                activations.at(sick, 0) = std::numeric_limits<double>::quiet_NaN();
                BOOST_TEST(!step(network, activations), lanes << ": cell " << sick << " of " << cells);
                for (int cell = 0; cell < cells; ++cell)
                    BOOST_TEST(std::isnan(activations.at(cell, 1)) == (cell == sick));
            }
    });
}

BOOST_AUTO_TEST_CASE(lanes_beyond_the_last_cell_do_not_count) {
    // A cell that was sick is removed.
    Genome genome = specimens::bare_genome(1, 1);
    add_link(genome, 0, 1, 1);
    const Network network = express(genome, 16);
    with_all_lanes([&](std::string_view lanes) {
        Activations activations(2, 3);
        activations.at(2, 0) = std::numeric_limits<double>::quiet_NaN();
        activations.remove(std::vector<char>{0, 0, 1});
        BOOST_TEST(step(network, activations), lanes);
    });
}
