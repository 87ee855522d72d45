// SPDX-License-Identifier: MIT
#include "evolution/population.h"

#include "genome/mutate.h"

#include "base/random.h"

#include <boost/test/unit_test.hpp>

using namespace planula;

BOOST_AUTO_TEST_CASE(the_first_generation_links_every_input_to_every_output) {
    const NeatParameters parameters;
    const Population population = initial_population({9, 6, false}, parameters, 3);
    BOOST_TEST(population.generation == 0);
    BOOST_TEST(population.genomes.size() == 300u);
    BOOST_TEST(population.threshold == 5);
    BOOST_TEST(population.best_ever == 0);
    BOOST_TEST(population.species.size() == 1u);
    BOOST_TEST(population.species[0].members.size() == 300u);
    BOOST_TEST(population.species[0].age == 0);
    BOOST_TEST(population.innovations.links() == 54);
    BOOST_TEST(population.innovations.next_node() == 15);
    for (std::size_t slot = 0; slot < population.genomes.size(); ++slot) {
        const Genome &genome = population.genomes[slot];
        BOOST_REQUIRE_NO_THROW(check_genome(genome));
        BOOST_TEST(genome.id == static_cast<std::int64_t>(slot));
        BOOST_TEST(genome.mother == -1);
        BOOST_TEST((genome.origin == Origin::initial));
        BOOST_TEST(genome.hidden() == 0);
        BOOST_TEST(genome.links.size() == 54u);
        for (int input = 0; input < 9; ++input)
            for (int output = 9; output < 15; ++output) BOOST_REQUIRE(genome.has_link(input, output));
    }
}

BOOST_AUTO_TEST_CASE(initial_weights_come_from_the_stream_of_their_slot) {
    const NeatParameters parameters;
    const Population population = initial_population({9, 5, true}, parameters, 42);
    for (const int slot : {0, 1, 299}) {
        Stream stream(42, 0, slot, Purpose::initial_weights);
        for (const auto &link : population.genomes[slot].links)
            BOOST_TEST(link.weight == new_weight(parameters.start_weight, parameters, stream));
    }
}

BOOST_AUTO_TEST_CASE(a_small_threshold_makes_many_species_from_the_start) {
    NeatParameters parameters;
    parameters.population = 50;
    parameters.compatibility_threshold = parameters.compatibility_floor = 0.5;
    const Population population = initial_population({9, 6, false}, parameters, 1);
    BOOST_TEST(population.species.size() > 10u);
    int slot = 0;
    for (const auto &species : population.species)
        for (const int member : species.members) BOOST_TEST(member == slot++);
    BOOST_TEST(slot == 50);
}
