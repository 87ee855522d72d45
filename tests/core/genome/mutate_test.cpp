// SPDX-License-Identifier: MIT
#include "genome/mutate.h"

#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

using namespace planula;
using specimens::bare;
using specimens::climbs;
using specimens::connected;

namespace {

/// A genome after `steps` mutations, most of them structural; every one of them is checked. Only a link out
/// of an output can make a dead end; it is taken back.
Genome grow(Genome genome, int steps, bool recurrent, Innovations &innovations, Stream &stream) {
    const NeatParameters parameters = specimens::structural();
    for (int step = 0; step < steps; ++step) {
        const Genome before = genome;
        mutate(parameters, recurrent, innovations, stream, genome);
        BOOST_REQUIRE_NO_THROW(check_genome(genome));
        BOOST_REQUIRE(recurrent || !has_dead_ends(genome));
        if (has_dead_ends(genome)) genome = before;
    }
    return genome;
}

} // namespace

BOOST_AUTO_TEST_CASE(ten_thousand_random_genomes_without_recurrence_are_acyclic) {
    Innovations innovations;
    const Genome ancestor = connected(3, 2, innovations);
    for (int n = 0; n < 10000; ++n) {
        Stream stream = specimens::stream(n);
        const Genome genome = grow(ancestor, 12, false, innovations, stream);
        BOOST_REQUIRE(climbs(genome)); // no cycle climbs all the way round
    }
}

BOOST_AUTO_TEST_CASE(operators_keep_every_invariant_in_recurrent_genomes_too) {
    Innovations innovations;
    const Genome ancestor = connected(4, 3, innovations);
    int loops = 0, backward = 0, level = 0;
    for (int n = 0; n < 2000; ++n) {
        Stream stream = specimens::stream(n);
        const Genome genome = grow(ancestor, 15, true, innovations, stream);
        for (const auto &link : genome.links) {
            const double rise = genome.find_node(link.to)->depth - genome.find_node(link.from)->depth;
            BOOST_REQUIRE(link.recurrent ? rise <= 0 : rise >= 0);
            loops += link.from == link.to;
            backward += rise < 0;
            level += rise == 0 && link.from != link.to && !link.recurrent;
        }
    }
    BOOST_TEST(loops > 0);
    BOOST_TEST(backward > 0);
    BOOST_TEST(level > 0); // forward links between nodes of one depth are for recurrent networks
}

BOOST_AUTO_TEST_CASE(the_two_ends_of_a_split_carry_one_and_the_old_weight) {
    const NeatParameters parameters;
    Innovations innovations(3);
    Genome genome = bare(2, 1);
    genome.links = {{innovations.link(0, 2), 0, 2, -3.25, false}};
    Stream stream = specimens::stream(1);
    BOOST_REQUIRE(add_node(parameters, false, innovations, stream, genome));
    BOOST_TEST(genome.nodes.size() == 4u);
    BOOST_TEST((genome.nodes[3] == NodeGene{3, NodeKind::hidden, 0.5}));
    const std::vector<LinkGene> expected{{1, 0, 3, 1, false}, {2, 3, 2, -3.25, false}}; // the old one is gone
    BOOST_TEST((genome.links == expected));
}

BOOST_AUTO_TEST_CASE(the_same_split_gets_the_same_ids_and_a_repeated_one_the_next) {
    const NeatParameters parameters;
    Innovations innovations(3);
    const LinkGene link{innovations.link(0, 2), 0, 2, 1, false};
    Genome plain = bare(2, 1);
    plain.links = {link};
    Stream stream = specimens::stream(2);
    const auto split = [&](Genome genome) {
        BOOST_REQUIRE(add_node(parameters, false, innovations, stream, genome));
        return genome;
    };
    const Genome once = split(plain);
    BOOST_TEST((split(plain) == once));

    // A genome that has the first node already gets a second, and so does every other like it.
    Genome relinked = once;
    relinked.links = {link};
    const Genome twice = split(relinked);
    BOOST_TEST(twice.hidden() == 2);
    BOOST_TEST(twice.nodes.back().id == 4);
    BOOST_TEST((split(relinked) == twice));

    // One that has the second alone gets the first.
    Genome second_only = twice;
    second_only.nodes.erase(second_only.nodes.end() - 2);
    second_only.links = {link};
    BOOST_TEST((split(second_only).nodes == twice.nodes));
    BOOST_TEST(innovations.splits(0, 2).size() == 2u);
}

BOOST_AUTO_TEST_CASE(links_from_the_bias_are_never_split) {
    const NeatParameters parameters;
    Innovations innovations(3);
    Genome genome = bare(2, 1);
    genome.links = {{innovations.link(1, 2), 1, 2, 1, false}};
    const Genome before = genome;
    Stream stream = specimens::stream(3);
    BOOST_TEST(!add_node(parameters, false, innovations, stream, genome));
    BOOST_TEST((genome == before));
    BOOST_TEST(innovations.next_node() == 3);
}

BOOST_AUTO_TEST_CASE(every_link_but_the_bias_is_split_equally_often) {
    const NeatParameters parameters;
    Innovations innovations;
    const Genome ancestor = connected(4, 2, innovations);
    std::array<int, 8> splits{};
    for (int n = 0; n < 6000; ++n) {
        Genome genome = ancestor;
        Stream stream = specimens::stream(n);
        BOOST_REQUIRE(add_node(parameters, false, innovations, stream, genome));
        for (int link = 0; link < 8; ++link) {
            const LinkGene &old = ancestor.links[link];
            splits[link] += !genome.has_link(old.from, old.to);
        }
    }
    // Six links with 1000 expected splits each: 150 is more than five standard deviations.
    for (int link = 0; link < 8; ++link)
        BOOST_TEST(std::abs(splits[link] - (link % 4 == 3 ? 0 : 1000)) < 150);
}

BOOST_AUTO_TEST_CASE(split_links_keep_their_recurrent_flag_loops_included) {
    const NeatParameters parameters;
    Innovations innovations(3);
    Genome genome = bare(2, 1);
    genome.links = {{innovations.link(2, 2), 2, 2, 0.5, true}};
    Stream stream = specimens::stream(4);
    BOOST_REQUIRE(add_node(parameters, true, innovations, stream, genome));
    BOOST_TEST((genome.nodes[3] == NodeGene{3, NodeKind::hidden, 1}));
    const std::vector<LinkGene> expected{{1, 2, 3, 1, true}, {2, 3, 2, 0.5, true}};
    BOOST_TEST((genome.links == expected));
}

BOOST_AUTO_TEST_CASE(an_acyclic_link_too_short_in_depth_is_not_split) {
    const NeatParameters parameters;
    Genome genome = bare(2, 1);
    genome.nodes.push_back({3, NodeKind::hidden, std::nextafter(1.0, 0.0)});
    Innovations innovations(4);
    genome.links = {{innovations.link(3, 2), 3, 2, 1, false}};
    Stream stream = specimens::stream(5);
    BOOST_TEST(!add_node(parameters, false, innovations, stream, genome));
    BOOST_TEST(add_node(parameters, true, innovations, stream, genome));
}

BOOST_AUTO_TEST_CASE(added_links_of_acyclic_networks_climb_and_those_of_full_networks_fail) {
    NeatParameters parameters;
    Innovations innovations;
    Genome genome = connected(3, 2, innovations);
    Stream stream = specimens::stream(6);
    const Genome before = genome;
    BOOST_TEST(!add_link(parameters, false, innovations, stream, genome));
    BOOST_TEST((genome == before));

    // Two hidden nodes of one depth: all links of the acyclic network are found, none between the two.
    genome.nodes.push_back({5, NodeKind::hidden, 0.5});
    genome.nodes.push_back({6, NodeKind::hidden, 0.5});
    parameters.link_tries = 10000;
    while (add_link(parameters, false, innovations, stream, genome)) BOOST_REQUIRE(climbs(genome));
    BOOST_TEST(genome.links.size() == 6u + 2 * (3 + 2));
    BOOST_TEST(!genome.has_link(5, 6));
    BOOST_TEST(!genome.has_link(6, 5));
}

BOOST_AUTO_TEST_CASE(recurrent_networks_also_take_level_backward_and_looped_links) {
    NeatParameters parameters;
    parameters.link_tries = 10000;
    Innovations innovations;
    Genome genome = connected(3, 2, innovations);
    genome.nodes.push_back({5, NodeKind::hidden, 0.5});
    genome.nodes.push_back({6, NodeKind::hidden, 0.5});

    // Forward only: the two level links between the hidden nodes appear, none out of an output.
    parameters.recurrent_rate = 0;
    Stream stream = specimens::stream(7);
    while (add_link(parameters, true, innovations, stream, genome)) check_genome(genome);
    BOOST_TEST(genome.links.size() == 6u + 2 * (3 + 2) + 2);
    for (const auto &link : genome.links) BOOST_TEST(!link.recurrent);

    // Backward only: from the outputs to the hidden nodes; output to output is level and out of reach.
    parameters.recurrent_rate = 1;
    parameters.loop_rate = 0;
    while (add_link(parameters, true, innovations, stream, genome)) check_genome(genome);
    BOOST_TEST(genome.links.size() == 18u + 4);
    BOOST_TEST(!genome.has_link(3, 4));

    // Loops on every node that is not an input.
    parameters.loop_rate = 1;
    while (add_link(parameters, true, innovations, stream, genome)) check_genome(genome);
    BOOST_TEST(genome.links.size() == 22u + 4);
    for (const int id : {3, 4, 5, 6}) BOOST_TEST(genome.has_link(id, id));
}

BOOST_AUTO_TEST_CASE(recurrence_comes_in_the_shares_asked_for) {
    const NeatParameters parameters;
    Innovations innovations;
    Genome ancestor = connected(3, 2, innovations);
    ancestor.nodes.push_back({5, NodeKind::hidden, 0.5});
    int recurrent = 0, loops = 0;
    for (int n = 0; n < 8000; ++n) {
        Genome genome = ancestor;
        Stream stream = specimens::stream(n);
        BOOST_REQUIRE(add_link(parameters, true, innovations, stream, genome));
        for (const auto &link : genome.links) {
            recurrent += link.recurrent;
            loops += link.from == link.to;
        }
    }
    BOOST_TEST(std::abs(recurrent - 2000) < 200); // 0.25, five standard deviations
    BOOST_TEST(std::abs(loops - 500) < 110);      // 0.25 of those
}

BOOST_AUTO_TEST_CASE(a_link_is_removed_only_if_no_dead_end_is_left) {
    const NeatParameters parameters;
    Innovations innovations(3);
    Genome genome = bare(2, 1);
    genome.nodes.push_back({3, NodeKind::hidden, 0.5});
    genome.links = {{0, 0, 3, 1, false}, {1, 3, 2, 1, false}, {2, 1, 3, 1, false}, {3, 1, 2, 1, false}};
    const Genome before = genome;
    for (int n = 0; n < 50; ++n) {
        Stream stream = specimens::stream(n);
        genome = before;
        BOOST_REQUIRE(remove_link(parameters, stream, genome));
        BOOST_TEST(!genome.has_link(1, 3)); // the only one that may go: the newest is never drawn
        BOOST_TEST(genome.links.size() == 3u);
    }

    genome = bare(2, 1);
    genome.links = {{0, 0, 2, 1, false}};
    const Genome single = genome;
    Stream stream = specimens::stream(99);
    BOOST_TEST(!remove_link(parameters, stream, genome));
    BOOST_TEST((genome == single));
}

BOOST_AUTO_TEST_CASE(removal_draws_all_links_but_the_newest_equally) {
    const NeatParameters parameters;
    Innovations innovations;
    const Genome ancestor = connected(3, 2, innovations);
    std::array<int, 6> removed{};
    for (int n = 0; n < 5000; ++n) {
        Genome genome = ancestor;
        Stream stream = specimens::stream(n);
        BOOST_REQUIRE(remove_link(parameters, stream, genome));
        for (int link = 0; link < 6; ++link)
            removed[link] += !genome.has_link(ancestor.links[link].from, ancestor.links[link].to);
    }
    for (int link = 0; link < 6; ++link) BOOST_TEST(std::abs(removed[link] - (link < 5 ? 1000 : 0)) < 150);
}

BOOST_AUTO_TEST_CASE(weights_are_all_replaced_or_all_moved_and_stay_within_the_limit) {
    NeatParameters parameters;
    parameters.weight_power = 1;
    Innovations innovations;
    Genome ancestor = connected(9, 6, innovations);
    for (auto &link : ancestor.links) link.weight = 5;
    int severe = 0;
    double moves = 0, squares = 0;
    for (int n = 0; n < 4000; ++n) {
        Genome genome = ancestor;
        Stream stream = specimens::stream(n);
        BOOST_REQUIRE(mutate_weights(parameters, stream, genome));
        const bool replaced = std::abs(genome.links[0].weight) <= 1;
        severe += replaced;
        for (const auto &link : genome.links) {
            const double move = replaced ? link.weight : link.weight - 5;
            BOOST_REQUIRE(std::abs(move) <= 1);
            moves += move, squares += move * move;
        }
    }
    BOOST_TEST(std::abs(severe - 1000) < 140);
    // The difference of two uniform draws has mean 0 and variance 1/6.
    BOOST_TEST(std::abs(moves / (4000 * 54)) < 0.005);
    BOOST_TEST(std::abs(squares / (4000 * 54) - 1.0 / 6) < 0.003);

    for (auto &link : ancestor.links) link.weight = 8;
    double largest = 0;
    for (int n = 0; n < 100; ++n) {
        Genome genome = ancestor;
        Stream stream = specimens::stream(n);
        mutate_weights(parameters, stream, genome);
        for (const auto &link : genome.links) largest = std::max(largest, std::abs(link.weight));
    }
    BOOST_TEST(largest == 8);
}

BOOST_AUTO_TEST_CASE(operators_are_drawn_by_their_weights_and_redrawn_when_they_fail) {
    const NeatParameters parameters;
    Innovations innovations;
    Genome ancestor = connected(3, 2, innovations);
    ancestor.nodes.push_back({5, NodeKind::hidden, 0.5});
    ancestor.links.push_back({innovations.link(0, 5), 0, 5, 1, false});
    ancestor.links.push_back({innovations.link(5, 3), 5, 3, 1, false});
    int nodes = 0, links = 0, removals = 0, weights = 0;
    for (int n = 0; n < 20000; ++n) {
        Genome genome = ancestor;
        Stream stream = specimens::stream(n);
        BOOST_REQUIRE(mutate(parameters, false, innovations, stream, genome));
        const int more = static_cast<int>(genome.links.size()) - static_cast<int>(ancestor.links.size());
        if (genome.hidden() > ancestor.hidden())
            ++nodes;
        else
            ++(more > 0 ? links : more < 0 ? removals : weights);
    }
    // Of 84 parts: 1, 7, 1, 75.
    BOOST_TEST(std::abs(nodes - 20000 / 84) < 80);
    BOOST_TEST(std::abs(removals - 20000 / 84) < 80);
    BOOST_TEST(std::abs(links - 20000 * 7 / 84) < 200);
    BOOST_TEST(std::abs(weights - 20000 * 75 / 84) < 230);

    // A full network has no room for a link, so that another operator takes the place.
    const Genome full = connected(3, 2, innovations);
    NeatParameters mostly_links = parameters;
    mostly_links.add_node_rate = mostly_links.remove_link_rate = 0;
    for (int n = 0; n < 100; ++n) {
        Genome genome = full;
        Stream stream = specimens::stream(n);
        BOOST_REQUIRE(mutate(mostly_links, false, innovations, stream, genome));
        BOOST_TEST(genome.links.size() == full.links.size());
        BOOST_TEST((genome.links != full.links));
    }
    mostly_links.mutate_weights_rate = 0;
    Genome genome = full;
    Stream stream = specimens::stream(0);
    BOOST_TEST(!mutate(mostly_links, false, innovations, stream, genome));
    BOOST_TEST((genome == full));
}

BOOST_AUTO_TEST_CASE(dead_ends_are_nodes_without_a_way_in_or_out) {
    const auto with = [](std::vector<LinkGene> links, bool hidden) {
        Genome genome = bare(2, 2); // input 0, bias 1, outputs 2 and 3
        if (hidden) genome.nodes.push_back({4, NodeKind::hidden, 0.5});
        genome.links = std::move(links);
        return has_dead_ends(genome);
    };
    BOOST_TEST(with({}, false));
    BOOST_TEST(!with({{0, 0, 2, 1, false}}, false)); // output 3 has no way in: not one
    BOOST_TEST(!with({{0, 0, 4, 1, false}, {1, 4, 2, 1, false}}, true));
    BOOST_TEST(with({{0, 4, 2, 1, false}, {1, 0, 2, 1, false}}, true));                     // no way in
    BOOST_TEST(with({{0, 1, 4, 1, false}, {1, 4, 2, 1, false}}, true));                     // the bias alone
    BOOST_TEST(with({{0, 4, 4, 1, true}, {1, 4, 2, 1, false}}, true));                      // a loop alone
    BOOST_TEST(with({{0, 0, 4, 1, false}, {1, 0, 2, 1, false}}, true));                     // no way out
    BOOST_TEST(with({{0, 0, 4, 1, false}, {1, 4, 4, 1, true}, {2, 0, 2, 1, false}}, true)); // but a loop
    BOOST_TEST(with({{0, 0, 2, 1, false}, {1, 2, 3, 1, true}}, false));                     // one in, one out
    BOOST_TEST(!with({{0, 0, 2, 1, false}, {1, 1, 2, 1, false}, {2, 2, 3, 1, true}}, false)); // two in
    BOOST_TEST(!with({{0, 0, 2, 1, false}, {1, 2, 2, 1, true}}, false)); // a loop counts neither way
}

BOOST_AUTO_TEST_CASE(weights_are_multiples_of_the_step) {
    NeatParameters parameters;
    parameters.weight_step = 0x1p-10;
    const auto is_multiple = [](const LinkGene &link) {
        return link.weight * 1024 == std::floor(link.weight * 1024);
    };
    Innovations innovations;
    Genome genome = connected(9, 6, innovations);
    Stream stream = specimens::stream(8);
    for (int n = 0; n < 100; ++n) {
        BOOST_REQUIRE(mutate_weights(parameters, stream, genome));
        BOOST_TEST(std::all_of(genome.links.begin(), genome.links.end(), is_multiple));
    }
}

BOOST_AUTO_TEST_CASE(new_weights_keep_to_their_scale_and_to_the_limit) {
    NeatParameters parameters;
    Stream stream = specimens::stream(8);
    std::set<double> seen;
    for (int n = 0; n < 100; ++n) seen.insert(new_weight(0.5, parameters, stream));
    BOOST_TEST(*seen.begin() >= -0.5);
    BOOST_TEST(*seen.rbegin() <= 0.5);
    for (int n = 0; n < 100; ++n) seen.insert(new_weight(100, parameters, stream));
    BOOST_TEST(*seen.begin() == -8);
    BOOST_TEST(*seen.rbegin() == 8);
}

BOOST_AUTO_TEST_CASE(mutation_repeats_bit_for_bit) {
    Innovations first, second;
    const Genome ancestor = connected(9, 5, first);
    connected(9, 5, second);
    for (int n = 0; n < 50; ++n) {
        Stream one = specimens::stream(n), two = specimens::stream(n);
        const Genome a = grow(ancestor, 30, true, first, one), b = grow(ancestor, 30, true, second, two);
        BOOST_REQUIRE((a == b));
    }
}
