// SPDX-License-Identifier: MIT
#include "evolution/brood.h"

#include "base/error.h"
#include "core/evolution/populations.h"

#include <boost/test/unit_test.hpp>

#include <limits>
#include <set>
#include <string_view>
#include <vector>

using namespace planula;

namespace {

/// Parents from outside the population: `count` genomes of different weights with ids from 100 on.
struct Pool {
    explicit Pool(int count) {
        for (int i = 0; i < count; ++i) {
            genomes.push_back(populations::with_weight(i, before.innovations));
            genomes.back().id = 100 + i;
            scores.push_back(count - i);
        }
    }
    Population brood(int size, std::uint64_t seed = 1) const {
        NeatParameters parameters;
        parameters.population = size;
        const ParentDraw draw = [&](Stream &stream) {
            return static_cast<int>(stream.below(static_cast<std::uint32_t>(genomes.size())));
        };
        return planula::brood(before, {genomes, scores, {}}, draw, false, parameters, seed);
    }
    Population before = populations::of({{1, 2}, {3}});
    std::vector<Genome> genomes;
    std::vector<double> scores;
};

} // namespace

BOOST_AUTO_TEST_CASE(a_brood_is_one_species_of_new_genomes_from_the_kept_parents) {
    const Pool pool(5);
    const Population next = pool.brood(40);
    BOOST_TEST(next.generation == 8);
    BOOST_TEST(next.next_genome == 43);
    BOOST_REQUIRE(next.species.size() == 1u);
    BOOST_TEST(next.species[0].id == 0);
    BOOST_TEST(next.species[0].age == 1);
    BOOST_REQUIRE(next.species[0].members.size() == 40u);
    std::set<std::int64_t> mothers;
    for (int slot = 0; slot < 40; ++slot) {
        const Genome &genome = next.genomes[slot];
        BOOST_TEST(next.species[0].members[slot] == slot);
        BOOST_TEST(genome.id == 3 + slot);
        BOOST_TEST((genome.mother >= 100 && genome.mother < 105 && genome.father < 105));
        BOOST_TEST((genome.origin != Origin::champion));
        mothers.insert(genome.mother);
    }
    BOOST_TEST(mothers.size() == 5u);
}

BOOST_AUTO_TEST_CASE(a_lone_parent_has_mutated_children_of_its_own) {
    const Population next = Pool(1).brood(20);
    for (const Genome &genome : next.genomes) {
        BOOST_TEST(genome.mother == 100);
        BOOST_TEST(genome.father == -1);
    }
}

BOOST_AUTO_TEST_CASE(a_brood_is_a_function_of_its_seed) {
    const Pool pool(4);
    BOOST_TEST((pool.brood(20).genomes == pool.brood(20).genomes));
    BOOST_TEST((pool.brood(20).genomes != pool.brood(20, 2).genomes));
}

BOOST_AUTO_TEST_CASE(a_brood_needs_parents_of_its_shape) {
    BOOST_CHECK_THROW(Pool(0).brood(3), InternalError);
    Pool pool(2);
    pool.genomes[1] = specimens::bare(3, 1);
    BOOST_CHECK_THROW(pool.brood(3), InternalError);
}

BOOST_AUTO_TEST_CASE(elites_read_back_equal_and_are_refused_if_cut_short) {
    const Pool pool(2);
    Elites elites;
    elites.add(pool.genomes[0], {3, {1, 2}, 0.1});
    elites.add(pool.genomes[1], {7, {std::numeric_limits<double>::quiet_NaN()}, 0}); // forgotten
    StateWriter writer;
    save(elites, pool.before.innovations, writer);
    StateReader reader(writer.bytes());
    const Elites read = load_elites(pool.before, reader);
    reader.done();
    BOOST_TEST((read.genomes == elites.genomes));
    BOOST_TEST((read.evaluations[0] == Evaluation{3, {1, 2}, 0.1}));
    BOOST_TEST((read.evaluations[1] == Evaluation{}));
    for (std::size_t length = 0; length < writer.bytes().size(); ++length) {
        StateReader cut(std::string_view(writer.bytes()).substr(0, length));
        BOOST_CHECK_THROW(load_elites(pool.before, cut), InputError);
    }
}
