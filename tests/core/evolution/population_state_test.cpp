// SPDX-License-Identifier: MIT
#include "evolution/population_state.h"

#include "base/error.h"
#include "base/random.h"
#include "core/evolution/populations.h"
#include "evolution/reproduce.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <utility>

using namespace planula;

namespace {

Parameters small() {
    Parameters parameters;
    parameters.neat.population = 20;
    parameters.design.generations = 50;
    parameters.neat.add_node_rate = parameters.neat.add_link_rate = 0.3;
    parameters.neat.compatibility_threshold = 1;
    return parameters;
}

constexpr std::uint64_t seed = 3;

/// Scores that differ from slot to slot and from generation to generation.
std::vector<double> scores_of(const Population &population) {
    std::vector<double> scores;
    for (const Genome &genome : population.genomes)
        scores.push_back(static_cast<double>((genome.id * 7 + population.generation) % 11));
    return scores;
}

void evolve(int generations, const NetworkShape &shape, const Parameters &parameters,
            Population &population) {
    for (int i = 0; i < generations; ++i)
        population = reproduce(population, scores_of(population), Adjustment::sharing, shape.recurrent,
                               parameters.neat, seed);
}

std::string saved(const Population &population) {
    StateWriter writer;
    save(population, writer);
    return writer.bytes();
}

Population loaded(const std::string &bytes, const NetworkShape &shape, const Parameters &parameters) {
    StateReader reader(bytes);
    Population population =
        load_population(shape, parameters.neat.population, parameters.design.generations, reader);
    reader.done();
    return population;
}

} // namespace

BOOST_AUTO_TEST_CASE(a_saved_population_continues_as_if_it_had_not_been_saved) {
    const Parameters parameters = small();
    for (const bool recurrent : {false, true}) {
        const NetworkShape shape{4, 2, recurrent};
        Population kept = initial_population(shape, parameters.neat, seed);
        for (int step = 0; step < 4; ++step) {
            Population back = loaded(saved(kept), shape, parameters);
            BOOST_TEST((saved(back) == saved(kept)));
            evolve(4, shape, parameters, kept);
            evolve(4, shape, parameters, back);
            BOOST_TEST((saved(back) == saved(kept)));
        }
        BOOST_TEST(kept.species.size() > 1u);
        BOOST_TEST(kept.innovations.next_node() > 6);
    }
}

BOOST_AUTO_TEST_CASE(a_population_cut_short_anywhere_is_refused) {
    const NetworkShape shape{2, 1, false};
    const Parameters parameters = populations::frozen(4);
    const std::string whole = saved(populations::far_apart({3, 1}));
    loaded(whole, shape, parameters);
    for (std::size_t length = 0; length < whole.size(); ++length)
        BOOST_CHECK_THROW(loaded(whole.substr(0, length), shape, parameters), InputError);
}

BOOST_AUTO_TEST_CASE(a_population_that_contradicts_itself_or_the_setting_is_refused) {
    const NetworkShape shape{2, 1, false};
    const Parameters parameters = populations::frozen(4);
    const auto refuses = [&](const char *rule, auto &&spoil) {
        Population population = populations::far_apart({3, 1});
        spoil(population);
        for (Species &species : population.species)
            if (!species.members.empty())
                species.representative = population.genomes[species.members.front()];
        const auto says = [&](const InputError &error) {
            return std::string(error.what()).find(rule) != std::string::npos;
        };
        BOOST_CHECK_EXCEPTION(loaded(saved(population), shape, parameters), InputError, says);
    };
    const double infinite = std::numeric_limits<double>::infinity();
    refuses("two species have one id", [](Population &p) { p.species[1].id = p.species[0].id; });
    refuses("two genomes have one id", [](Population &p) { p.genomes[1].id = p.genomes[0].id; });
    refuses("is not born yet", [](Population &p) { p.genomes[2].id = p.next_genome; });
    refuses("is not born yet", [](Population &p) { p.genomes[2].mother = p.next_genome; });
    refuses("hold the mark", [](Population &p) { p.species[0].best = p.species[1].best = true; });
    refuses("is not between", [](Population &p) { p.generation = -1; });
    refuses("is not between", [&](Population &p) { p.generation = parameters.design.generations; });
    refuses("is not between", [](Population &p) { p.species[0].age = -1; });
    refuses("is not between", [](Population &p) { p.species[0].id = p.next_species; });
    refuses("is not finite", [&](Population &p) { p.threshold = infinite; });
    refuses("below 0", [](Population &p) { p.threshold = -1; });
    refuses("below 0", [](Population &p) { p.species[0].best_ever = -1; });
    refuses("is not finite", [&](Population &p) { p.best_ever = infinite; });
    refuses("is not finite", [&](Population &p) { p.genomes[3].links[0].weight = infinite; });
    refuses("does not climb", [](Population &p) { p.genomes[3].links[0].recurrent = true; });
    refuses("setting's size", [](Population &p) {
        p.genomes.pop_back();
        p.species.pop_back();
    });
}

BOOST_AUTO_TEST_CASE(a_population_of_another_shape_is_refused) {
    const Population population = populations::far_apart({3, 1}); // two inputs, one output
    for (const NetworkShape shape : {NetworkShape{1, 2, false}, NetworkShape{3, 1, false}})
        BOOST_CHECK_THROW(loaded(saved(population), shape, populations::frozen(4)), InputError);

    // The innovations alone are of another shape.
    StateWriter record, other;
    population.innovations.save(record);
    Innovations(4).save(other);
    std::string bytes = saved(population);
    bytes.replace(bytes.find(record.bytes()), record.bytes().size(), other.bytes());
    BOOST_CHECK_THROW(loaded(bytes, {2, 1, false}, populations::frozen(4)), InputError);
}

BOOST_AUTO_TEST_CASE(a_population_that_its_innovations_do_not_explain_is_not_saved) {
    const auto not_saved = [](auto &&spoil) {
        Population population = populations::far_apart({3, 1});
        spoil(population);
        BOOST_CHECK_THROW(saved(population), InternalError);
    };
    not_saved([](Population &p) { p.genomes[1].links[0].innovation = 1; });
    not_saved([](Population &p) { p.genomes[1].links[0].from = 1; });
    not_saved([](Population &p) { p.genomes[1].nodes[2].depth = 0.5; });
    not_saved([](Population &p) { p.genomes[1] = specimens::bare(1, 2); });
    not_saved([](Population &p) { p.innovations = Innovations(3); });
    not_saved([](Population &p) { p.innovations = Innovations(4); });
}

BOOST_AUTO_TEST_CASE(any_damage_is_refused_or_leaves_a_population_that_can_reproduce) {
    const NetworkShape shape{3, 2, false};
    const Parameters parameters = small();
    Population population = initial_population(shape, parameters.neat, seed);
    evolve(6, shape, parameters, population);
    const std::string whole = saved(population);
    Stream stream(9, 0, 0, Purpose::sampling);
    int refused = 0, bred = 0;
    for (int i = 0; i < 1500; ++i) {
        // A bit, a byte, or a whole number that is as large as can be.
        std::string bytes = whole;
        const std::size_t at = stream.below(static_cast<std::uint32_t>(bytes.size() / 8)) * 8;
        const std::uint32_t kind = stream.below(3);
        if (kind == 0) bytes[at + stream.below(8)] ^= static_cast<char>(1 << stream.below(8));
        if (kind == 1) bytes[at] = static_cast<char>(stream.below(256));
        if (kind == 2) bytes.replace(at, 8, std::string(7, '\xff') + '\x7f');
        try {
            Population damaged = loaded(bytes, shape, parameters);
            evolve(1, shape, parameters, damaged);
            ++bred;
        } catch (const InputError &) {
            ++refused;
        }
    }
    BOOST_TEST(refused > 300);
    BOOST_TEST(bred > 100);
}

BOOST_AUTO_TEST_CASE(an_incomplete_generation_is_not_saved) {
    Population population = populations::far_apart({2, 2});
    std::swap(population.species[0].members[0], population.species[0].members[1]);
    BOOST_CHECK_THROW(saved(population), InternalError);
}
