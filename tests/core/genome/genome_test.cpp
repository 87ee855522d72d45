// SPDX-License-Identifier: MIT
#include "genome/genome.h"

#include "base/error.h"
#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <string>

using namespace planula;

namespace {

/// Three inputs, two outputs, hidden node 7 on the way from input 0 to output 4.
Genome sound() {
    Genome genome = specimens::bare(3, 2);
    genome.id = 12;
    genome.nodes.push_back({7, NodeKind::hidden, 0.5});
    genome.links = {{0, 0, 3, 0.5, false}, {4, 0, 7, 1, false}, {5, 7, 4, -2, false}, {9, 4, 7, 1, true}};
    return genome;
}

/// Whether check_genome refuses the genome with a message that holds these words.
bool refused(const Genome &genome, const std::string &words) {
    try {
        check_genome(genome);
    } catch (const InputError &error) {
        const std::string message = error.what();
        BOOST_TEST_MESSAGE(message);
        return message.find("genome 12") == 0 && message.find(words) != std::string::npos;
    }
    return false;
}

} // namespace

BOOST_AUTO_TEST_CASE(terminal_nodes_are_inputs_the_bias_and_outputs) {
    BOOST_TEST((terminal_nodes(3, 2) == specimens::bare(3, 2).nodes));
    BOOST_TEST((terminal_nodes(1, 1) == specimens::bare(1, 1).nodes));
}

BOOST_AUTO_TEST_CASE(linked_nodes_are_there_once_and_ascend) {
    BOOST_TEST(linked_nodes(5, sound().links) == std::vector{7}, boost::test_tools::per_element());
    BOOST_TEST(linked_nodes(0, sound().links) == (std::vector{0, 3, 4, 7}), boost::test_tools::per_element());
    BOOST_TEST(linked_nodes(8, sound().links).empty());
}

BOOST_AUTO_TEST_CASE(a_sound_genome_passes) { BOOST_CHECK_NO_THROW(check_genome(sound())); }

BOOST_AUTO_TEST_CASE(every_broken_rule_of_nodes_is_named) {
    Genome genome = sound();
    genome.inputs = 0;
    BOOST_TEST(refused(genome, "0 inputs"));

    genome = sound();
    genome.nodes.resize(4);
    BOOST_TEST(refused(genome, "missing"));

    genome = sound();
    genome.nodes[2].kind = NodeKind::input;
    BOOST_TEST(refused(genome, "node 2 is of kind input in the place of kind bias"));

    genome = sound();
    genome.nodes[3].id = 5;
    BOOST_TEST(refused(genome, "node 5 is in the place of node 3"));

    genome = sound();
    genome.nodes.push_back({6, NodeKind::hidden, 0.5});
    BOOST_TEST(refused(genome, "node 6 does not follow node 7"));

    for (const double depth : {-0.1, 1.5, std::numeric_limits<double>::quiet_NaN()}) {
        genome = sound();
        genome.nodes[5].depth = depth;
        BOOST_TEST(refused(genome, "node 7 of kind hidden has depth"));
    }
    genome = sound();
    genome.nodes[3].depth = 0.5;
    BOOST_TEST(refused(genome, "node 3 of kind output has depth 0.5"));
}

BOOST_AUTO_TEST_CASE(every_broken_rule_of_links_is_named) {
    Genome genome = sound();
    std::swap(genome.links[0], genome.links[1]);
    BOOST_TEST(refused(genome, "link 0 (0 to 3) does not follow link 4"));

    genome = sound();
    genome.links[2].from = 0, genome.links[2].to = 3;
    BOOST_TEST(refused(genome, "two links join 0 to 3"));

    genome = sound();
    genome.links[1].from = 6;
    BOOST_TEST(refused(genome, "link 4 (6 to 7) starts at a node that is not there"));

    genome = sound();
    genome.links[1].to = 8;
    BOOST_TEST(refused(genome, "ends at a node that is not there"));

    for (const int input : {1, 2}) {
        genome = sound();
        genome.links[1].to = input;
        BOOST_TEST(refused(genome, "enters an input"));
    }
    for (const double weight :
         {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
        genome = sound();
        genome.links[3].weight = weight;
        BOOST_TEST(refused(genome, "link 9 (4 to 7) has the weight"));
    }
}

BOOST_AUTO_TEST_CASE(nodes_and_links_are_found_by_their_ids) {
    const Genome genome = sound();
    BOOST_TEST(genome.find_node(7) == &genome.nodes[5]);
    BOOST_TEST(genome.find_node(6) == nullptr);
    BOOST_TEST(genome.find_node(8) == nullptr);
    BOOST_TEST(genome.has_link(4, 7));
    BOOST_TEST(!genome.has_link(3, 0));
    BOOST_TEST(genome.hidden() == 1);
}
