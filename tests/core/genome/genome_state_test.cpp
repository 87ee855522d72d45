// SPDX-License-Identifier: MIT
#include "genome/genome_state.h"

#include "base/error.h"
#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <string>

using namespace planula;

namespace {

/// A genome with hidden nodes, after so many mutations.
Genome grown(std::uint32_t number, bool recurrent) {
    Innovations innovations;
    Genome genome = specimens::connected(4, 2, innovations);
    Stream stream = specimens::stream(number);
    for (int i = 0; i < 30; ++i) mutate(specimens::structural(), recurrent, innovations, stream, genome);
    genome.id = number, genome.mother = number + 7, genome.origin = Origin::crossover_mutation;
    return genome;
}

std::string bytes_of(const Genome &genome) {
    StateWriter writer;
    save(genome, writer);
    return writer.bytes();
}

void refused(const Genome &genome) {
    const std::string bytes = bytes_of(genome);
    StateReader reader(bytes);
    BOOST_CHECK_THROW(load_genome(reader), InputError);
}

} // namespace

BOOST_AUTO_TEST_CASE(a_saved_genome_reads_back_equal) {
    for (std::uint32_t number = 0; number < 50; ++number) {
        const Genome genome = grown(number, number % 2 == 1);
        const std::string bytes = bytes_of(genome);
        StateReader reader(bytes);
        BOOST_TEST_REQUIRE((load_genome(reader) == genome));
        reader.done();
    }
}

BOOST_AUTO_TEST_CASE(a_genome_cut_short_anywhere_is_refused) {
    const std::string whole = bytes_of(grown(3, true));
    for (std::size_t length = 0; length < whole.size(); ++length) {
        StateReader reader(std::string_view(whole).substr(0, length));
        BOOST_CHECK_THROW(load_genome(reader), InputError);
    }
}

BOOST_AUTO_TEST_CASE(a_genome_that_breaks_a_rule_is_refused) {
    const Genome sound = grown(1, true);
    const auto with = [&](auto change) {
        Genome genome = sound;
        change(genome);
        refused(genome);
    };
    with([](Genome &g) { g.id = -1; });
    with([](Genome &g) { g.mother = -2; });
    with([](Genome &g) { g.origin = static_cast<Origin>(7); });
    with([](Genome &g) { g.inputs = 0; });
    with([](Genome &g) { g.inputs = g.outputs = std::numeric_limits<int>::max(); });
    with([](Genome &g) { g.nodes[0].kind = static_cast<NodeKind>(4); });
    with([](Genome &g) { g.nodes[0].depth = std::numeric_limits<double>::quiet_NaN(); });
    with([](Genome &g) { g.links[0].weight = std::numeric_limits<double>::infinity(); });
    with([](Genome &g) { g.links[1].innovation = g.links[0].innovation; }); // a rule of check_genome
}

BOOST_AUTO_TEST_CASE(random_damage_is_refused_or_read_as_a_sound_genome) {
    const std::string whole = bytes_of(grown(2, true));
    Stream stream = specimens::stream(0);
    for (int round = 0; round < 5000; ++round) {
        std::string damaged = whole;
        const std::size_t place = stream.below(static_cast<std::uint32_t>(whole.size()));
        damaged[place] = static_cast<char>(damaged[place] ^ 1 << stream.below(8));
        StateReader reader(damaged);
        Genome genome = specimens::bare(1, 1);
        try {
            genome = load_genome(reader);
        } catch (const InputError &) {
        }
        BOOST_REQUIRE_NO_THROW(check_genome(genome));
    }
}
