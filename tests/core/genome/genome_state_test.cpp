// SPDX-License-Identifier: MIT
#include "genome/genome_state.h"

#include "base/error.h"
#include "core/genome/specimens.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <string>

using namespace planula;

namespace {

constexpr int inputs = 4, outputs = 2;

/// Genomes of one run with hidden nodes, the later ones after more mutations.
struct Relatives {
    Relatives(int count, std::uint32_t number, bool recurrent) {
        Genome genome = specimens::connected(inputs, outputs, innovations);
        Stream stream = specimens::stream(number);
        for (int id = 0; id < count; ++id) {
            for (int i = 0; i < 10; ++i)
                mutate(specimens::structural(), recurrent, innovations, stream, genome);
            genome.id = id, genome.mother = id - 1, genome.father = id + 7;
            genome.origin = static_cast<Origin>(id % 7);
            genomes.push_back(genome);
        }
    }
    std::string bytes() const {
        StateWriter writer;
        save(genomes, innovations, writer);
        return writer.bytes();
    }
    std::vector<Genome> loaded(std::string_view bytes) const {
        StateReader reader(bytes);
        std::vector<Genome> back = load_genomes(inputs, outputs, innovations, reader);
        reader.done();
        return back;
    }

    Innovations innovations;
    std::vector<Genome> genomes;
};

/// Saved state by hand: genomes of these numbers of links, with these steps from innovation to innovation.
StateWriter columns(const std::vector<int> &links, int all, const std::vector<std::int64_t> &steps) {
    StateWriter writer;
    writer.group("genomes").integer(static_cast<std::int64_t>(links.size()));
    for (int column = 0; column < 4; ++column) // ids, mothers, fathers, origins
        for (std::size_t i = 0; i < links.size(); ++i) writer.integer(static_cast<std::int64_t>(i));
    writer.integer(all);
    for (const int number : links) writer.integer(number);
    for (const std::int64_t step : steps) writer.integer(step);
    for (std::size_t i = 0; i < steps.size(); ++i) writer.real(0.5);
    return writer;
}

} // namespace

BOOST_AUTO_TEST_CASE(saved_genomes_read_back_equal) {
    for (std::uint32_t number = 0; number < 50; ++number) {
        const Relatives run(static_cast<int>(number % 5), number, number % 2 == 1);
        BOOST_TEST_REQUIRE((run.loaded(run.bytes()) == run.genomes));
    }
}

BOOST_AUTO_TEST_CASE(genomes_cut_short_anywhere_are_refused) {
    const Relatives run(3, 3, true);
    const std::string whole = run.bytes();
    for (std::size_t length = 0; length < whole.size(); ++length)
        BOOST_CHECK_THROW(run.loaded(std::string_view(whole).substr(0, length)), InputError);
}

BOOST_AUTO_TEST_CASE(genomes_that_break_a_rule_are_refused) {
    const auto with = [](auto change) {
        Relatives run(2, 1, true);
        change(run.genomes[1]);
        BOOST_CHECK_THROW(run.loaded(run.bytes()), InputError);
    };
    with([](Genome &g) { g.id = -1; });
    with([](Genome &g) { g.mother = -2; });
    with([](Genome &g) { g.father = -2; });
    with([](Genome &g) { g.origin = static_cast<Origin>(7); });
    with([](Genome &g) { g.links[0].weight = std::numeric_limits<double>::infinity(); });
}

BOOST_AUTO_TEST_CASE(numbers_of_links_and_innovations_that_cannot_be_are_refused) {
    const Relatives run(0, 1, true);
    const auto refused = [&](const StateWriter &writer) {
        BOOST_CHECK_THROW(run.loaded(writer.bytes()), InputError);
    };
    constexpr std::int64_t largest = std::numeric_limits<std::int64_t>::max();
    const std::int64_t last = 2 * run.innovations.links() - 1; // the last innovation, recurrent
    BOOST_TEST(run.loaded(columns({1, 2}, 3, {last, 0, 2}).bytes()).size() == 2u);
    for (const std::int64_t step : {std::int64_t{-1}, last + 1, largest}) refused(columns({1}, 1, {step}));
    refused(columns({2}, 2, {last, 0}));
    refused(columns({1, 2}, 2, {0, 0}));
    refused(columns({1, 1}, 3, {0, 0, 0}));
    refused(columns({-1, 2}, 1, {0}));
    refused(columns({1}, std::numeric_limits<int>::max(), {0}));
    refused(StateWriter().group("genomes").integer(largest));
}

BOOST_AUTO_TEST_CASE(a_link_into_an_input_is_refused) {
    // Of a record that no run can have.
    Innovations innovations(inputs + outputs);
    innovations.link(0, 1);
    const StateWriter writer = columns({1}, 1, {0});
    StateReader reader(writer.bytes());
    BOOST_CHECK_THROW(load_genomes(inputs, outputs, innovations, reader), InputError);
}

BOOST_AUTO_TEST_CASE(random_damage_is_refused_or_read_as_sound_genomes) {
    const Relatives run(3, 2, true);
    const std::string whole = run.bytes();
    Stream stream = specimens::stream(0);
    for (int round = 0; round < 5000; ++round) {
        std::string damaged = whole;
        const std::size_t place = stream.below(static_cast<std::uint32_t>(whole.size()));
        damaged[place] = static_cast<char>(damaged[place] ^ 1 << stream.below(8));
        std::vector<Genome> genomes;
        try {
            genomes = run.loaded(damaged);
        } catch (const InputError &) {
        }
        for (const Genome &genome : genomes) BOOST_REQUIRE_NO_THROW(check_genome(genome));
    }
}
